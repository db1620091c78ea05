// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/mesh/shell_mesh.h>
#include <biface/stepping/masses_of_stage.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  std::vector<MovingMass>
  masses_of_stage(const Stage &stage, const ShellMesh &mesh, const State &state)
  {
    std::vector<MovingMass> masses;
    for (const MotionByForce &item : stage.motions_by_force)
      {
        const unsigned int factor     = item.motion.factor;
        const Suspension  &suspension = item.motion.suspension;
        const auto         motion     = MovingMass::motion_in(state, factor);
        MovingMass         mass;
        mass.factor = factor;
        mass.amplitude =
          (item.moves_supports()
             ? common_motion(mesh.supported.motions, factor).value().amount
             : item.motion.amplitude());
        mass.mass              = suspension.mass;
        mass.damping           = suspension.damper;
        mass.stiffness         = suspension.spring;
        mass.velocity          = motion.velocity;
        mass.last_acceleration = motion.acceleration;
        masses.push_back(mass);
      }
    return masses;
  }


  double
  velocity_by_masses(const PrescribedDisplacement  &prescribed,
                     const std::vector<MovingMass> &masses)
  {
    double sum = 0;
    for (const MovingMass &mass : masses)
      sum += prescribed.values[mass.factor] * mass.velocity / mass.amplitude;
    return sum;
  }
} // namespace Biface
