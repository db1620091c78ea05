// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/contact/rigid_body.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/state/loads.h>
#include <biface/output/csv.h>
#include <biface/output/reaction_columns.h>

namespace Biface
{
  std::vector<std::string>
  reaction_columns(const ShellMesh &mesh)
  {
    std::vector<std::string> columns;
    for (const SupportMotion &motion : mesh.supported.motions)
      for (const char *what : {motion.displacement_name(), motion.force_name()})
        columns.push_back(with_underscores(motion.name) + '_' + what);
    return columns;
  }


  std::vector<double>
  reaction_values(const ShellMesh                 &mesh,
                  const Loads                     &loads,
                  const std::vector<ForceOnShell> &forces)
  {
    std::vector<double> values;
    for (const SupportReaction &reaction :
         support_reactions(mesh, loads, forces))
      {
        values.push_back(reaction.displacement);
        values.push_back(reaction.force);
      }
    return values;
  }


  std::string
  columns_of_forces(const ShellMesh &mesh)
  {
    std::string text = "force,reaction";
    for (const std::string &column : reaction_columns(mesh))
      text += ',' + column;
    return text;
  }


  std::string
  values_of_forces(const ShellMesh                 &mesh,
                   const Loads                     &loads,
                   const std::vector<ForceOnShell> &forces)
  {
    // the ground pushes inward: compressive forces are positive
    const RigidBody *ground  = loads.ground();
    double           largest = 0;
    for (unsigned int b = 0; b < mesh.supported.bodies.size(); ++b)
      largest = std::max(largest, forces[b].force.norm());
    std::vector<double> values{
      ground ? -(force_of_ground(forces).force * ground->direction()) : 0.,
      largest};
    for (const double value : reaction_values(mesh, loads, forces))
      values.push_back(value);
    std::string text;
    for (const double value : values)
      text += ',' + csv_number(value);
    return text;
  }
} // namespace Biface
