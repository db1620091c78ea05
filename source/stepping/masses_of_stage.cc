// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/masses_of_stage.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  std::vector<MovingMass>
  masses_of_stage(const Stage     &stage,
                  const ShellMesh &mesh,
                  const State     &state,
                  const Loads     &loads,
                  const double     duration)
  {
    std::vector<MovingMass> masses;
    for (const MotionByForce &item : stage.motions_by_force)
      {
        const unsigned int factor     = item.motion.factor;
        const Suspension  &suspension = item.motion.suspension;
        MovingMass         mass;
        mass.factor    = factor;
        mass.amplitude = item.motion.amplitude();
        // supports have what the whole structure has, and the part that is
        // modeled its share
        double share = 1;
        if (item.moves_supports())
          {
            const SupportMotion motion =
              common_motion(mesh.supported.motions, factor).value();
            mass.amplitude = motion.amount;
            share          = 1 / motion.multiple;
          }
        mass.mass         = share * suspension.mass;
        mass.damping      = share * suspension.damper;
        mass.stiffness    = share * suspension.spring;
        mass.duration     = duration;
        mass.displacement = mass.amplitude * factor_at(loads.factors, factor);
        const auto motion = MovingMass::motion_in(state, factor);
        mass.velocity     = motion.velocity;
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
