// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/stepping/moving_reactions.h>

namespace Biface
{
  using namespace dealii;

  MovingReactions
  moving_reactions(const ShellEquations            &equations,
                   const LoadLevel                 &level,
                   const Loads                     &loads,
                   const std::vector<ForceOnShell> &forces)
  {
    MovingReactions  result{level, {}};
    const ShellMesh &mesh     = equations.mesh;
    const auto       supports = support_reactions(mesh, loads, forces);
    for (unsigned int m = 0; m < supports.size(); ++m)
      {
        MovingReaction &motion = result.of[mesh.supported.motions[m].name];
        motion.displacement[0] = supports[m].displacement;
        motion.force[0]        = supports[m].force;
      }
    for (const auto &[number, body_there] : loads.bodies)
      {
        const PlacedBody &placed = *body_there;
        MovingReaction   &body   = result.of[placed.name];
        body.displacement        = placed.body.displacement_of_point();
        body.rotation            = placed.body.rotation_vector();
        if (number == 0)
          {
            const Tensor<1, 3> &outward = placed.body.direction();
            body.displacement           = level.slide - level.travel * outward;
            body.rotation               = level.turn * outward;
          }
        for (const ForceOnShell &item : forces)
          if (item.body == placed.name)
            body.force = item.force;
      }
    return result;
  }
} // namespace Biface
