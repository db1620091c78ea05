// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_attempt_h
#define biface_stepping_attempt_h

#include <memory>

#include <biface/model/equations/equation_system.h>
#include <biface/model/state/state.h>
#include <biface/solver/newton.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  class ContactLaws;
  struct ControlTrial;
  class StageRun;


  /** The result of an attempt at a step. */
  struct Attempt
  {
    NewtonResult   result;
    State          state;
    LoadParameters mu;
    /** The loads at the final load parameters. */
    LoadLevel level;
    /** How often rolling and the conduction of heat were computed in turn, see
     * RollingHeat::Iteration. */
    unsigned int n_heat_rounds = 0;
    /** Whether the attempt has left the path for another branch. */
    bool to_branch = false;
    /** How often the step was halved before. */
    unsigned int n_cuts = 0;
    /** The error of a step in time, see Biface::error_in_time(); 0 if it was
     * not asked for. */
    double error_in_time = 0;
  };


  /** The state and load parameters from which Newton's method starts. */
  struct InitialGuess
  {
    State          state;
    LoadParameters mu;
    /** Whether the active set of the state is kept in the first iteration, see
     * Newton::solve(). */
    bool zone_given = false;
  };


  /** Attempt a step by Newton's method.
   * @param laws those of the ground in place of those of the stage. */
  Attempt
  attempt_step(Newton               &newton,
               const StageRun       &run,
               const ControlTrial   &trial,
               const InitialGuess   &guess,
               const NewtonIteration iteration,
               const ContactLaws    &laws);

  /** Attempt a step by Newton's method with the laws of the stage. */
  Attempt
  attempt_step(Newton               &newton,
               const StageRun       &run,
               const ControlTrial   &trial,
               const InitialGuess   &guess,
               const NewtonIteration iteration);
} // namespace Biface

#endif
