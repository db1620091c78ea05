// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_attempt_in_time_h
#define biface_stepping_attempt_in_time_h

#include <memory>
#include <optional>

#include <biface/model/time/energy_of_motion.h>
#include <biface/stepping/attempt.h>

namespace Biface
{
  struct ControlTrial;
  class NodalForces;
  struct StepInTime;


  /** Attempt a StepInTime by Newton's method.
   * @param newton one that knows nothing of contact, which has no active set in
   * time. */
  Attempt
  attempt_step_in_time(Newton             &newton,
                       const StageRun     &run,
                       const ControlTrial &trial);

  /** The forces on the nodes over the step of a converged attempt. */
  std::shared_ptr<const NodalForces>
  forces_over_step(const StageRun &run, const Attempt &attempt);

  /** What has happened in a step in time: its work, the energies at its end,
   * and the mean moment of the axle on a wheel that rolls. */
  struct EndOfStepInTime
  {
    Work                  work;
    EnergyOfMotion        energy;
    std::optional<double> axle_moment;
  };


  /** Complete the state at the end of a step in time: set its velocities and
   * what the next step needs for its error.
   * @param loads at the end of the step.
   * @param forces on the nodes over the step. */
  EndOfStepInTime
  end_step_in_time(const StageRun                          &run,
                   const std::shared_ptr<const StepInTime> &step,
                   const Loads                             &loads,
                   const NodalForces                       &forces,
                   State                                   &state);
} // namespace Biface

#endif
