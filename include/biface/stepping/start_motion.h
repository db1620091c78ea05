// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_start_motion_h
#define biface_stepping_start_motion_h

#include <string>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  struct Loads;
  class ShellEquations;
  struct Stage;
  struct State;


  /** The loads before a step in time, in its middle and after it, and its
   * duration. */
  struct LoadsOfStepInTime
  {
    const Loads &before, &middle, &after;
    double       duration;
  };


  /** How supports that move go through a step in time: the velocities at its
   * start and at its end by their places there and in its middle, and the mean
   * one. Locally owned entries, of use at prescribed displacements only. Unit:
   * length/time. */
  struct MotionOfSupports
  {
    MotionOfSupports(const ShellEquations    &equations,
                     const State             &state,
                     const LoadsOfStepInTime &loads);

    LA::Vector at_start, at_end, mean;
  };


  /** Set the velocities of a state at the start of a stage with inertia: those
   * that the stage gives or, without them, those that the state has, if any.
   * Supports that move have their velocity at once; those that masses move,
   * that of the shell there. Throws InputError on all ranks if a formula has no
   * value at a node.
   * @param section that of the stage.
   * @param first the loads in the first step, without the motions of masses. */
  void
  start_motion(const ShellEquations    &equations,
               const Stage             &stage,
               const std::string       &section,
               const LoadsOfStepInTime &first,
               State                   &state);
} // namespace Biface

#endif
