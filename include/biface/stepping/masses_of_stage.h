// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_masses_of_stage_h
#define biface_stepping_masses_of_stage_h

#include <vector>

#include <biface/model/state/moving_mass.h>

namespace Biface
{
  struct Loads;
  struct PrescribedDisplacement;
  class ShellMesh;
  struct Stage;


  /** The bodies and supports whose motions forces find in a stage with inertia,
   * in the order of StageControl::motions_by_force.
   * @param state, loads at the start of the step.
   * @param duration of the step. */
  std::vector<MovingMass>
  masses_of_stage(const Stage     &stage,
                  const ShellMesh &mesh,
                  const State     &state,
                  const Loads     &loads,
                  const double     duration);


  /** The velocity of a prescribed displacement by masses that carry its
   * support.
   */
  double
  velocity_by_masses(const PrescribedDisplacement  &prescribed,
                     const std::vector<MovingMass> &masses);
} // namespace Biface

#endif
