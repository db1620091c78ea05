// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/equations/shell_equations.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/stepping/moving_reactions.h>

namespace Biface
{
  using namespace dealii;

  MovingReaction
  without_force(const PlacedBody &placed)
  {
    MovingReaction result;
    result.displacement = placed.body.displacement_of_point();
    result.rotation     = placed.body.rotation_vector();
    return result;
  }


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
        MovingReaction &body = result.of[body_there->name];
        body                 = without_force(*body_there);
        for (const ForceOnShell &item : forces)
          if (item.body == body_there->name)
            {
              body.force  = item.force;
              body.moment = item.moment;
            }
      }
    return result;
  }
} // namespace Biface
