// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_start_motion_h
#define biface_stepping_start_motion_h

#include <string>

#include <biface/model/equations/shell_equations.h>

namespace Biface
{
  struct StageMotion;


  /** The first step of a stage with inertia: the loads before it, in its middle
   * and after it, and its duration. */
  struct FirstStepInTime
  {
    const Loads &before, &middle, &after;
    double       duration;
  };


  /** Set the velocities of a state at the start of a stage with inertia: those
   * that the stage gives or, without them, those that the state has, if any.
   * Supports that move have their velocity at once. Throws InputError
   * on all ranks if a formula has no value at a node.
   * @param section that of the stage. */
  void
  start_motion(const ShellEquations  &equations,
               const StageMotion     &stage,
               const std::string     &section,
               const FirstStepInTime &first,
               State                 &state);
} // namespace Biface

#endif
