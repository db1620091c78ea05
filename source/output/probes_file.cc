// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/output/csv.h>
#include <biface/output/probes_file.h>

namespace Biface
{
  using namespace dealii;

  PointDisplacement
  displacement_at(const NamedPoint &point,
                  const LA::Vector &displacement,
                  const ShellMesh  &mesh)
  {
    PointDisplacement  u;
    const unsigned int n = mesh.node_of_point("Named points", point.name);
    // known by the rank that owns the node
    if (n != numbers::invalid_unsigned_int && mesh.nodes[n].locally_owned)
      for (unsigned int face = 0; face < 2; ++face)
        {
          const Node &node = mesh.nodes[n];
          u.local[face]    = mesh.displacement(displacement, node, face);
          u.global[face]   = node.surface.from_frame(u.local[face]);
        }
    for (const auto faces : {&u.global, &u.local})
      for (Tensor<1, 3> &value : *faces)
        value = Utilities::MPI::sum(value, mesh.communicator);
    return u;
  }


  ProbesFile::ProbesFile(ResultsDirectory     &directory,
                         const ShellEquations &equations)
    : StepTable("probes.csv",
                "step,stage,load_factor,name,face,u_x,u_y,u_z,u_1,u_2,u_3",
                3 * equations.mesh.points.size(),
                directory,
                equations)
  {}


  bool
  ProbesFile::is_wanted() const
  {
    return !equations.mesh.points.empty();
  }


  void
  ProbesFile::write(const StepReport &report, const State &state)
  {
    std::string lines;
    for (const NamedPoint &point : equations.mesh.points)
      {
        const PointDisplacement u =
          displacement_at(point, state.displacement, equations.mesh);
        const auto add = [&](const std::string &face,
                             const double       share_of_inner) {
          lines += std::to_string(report.step) + ',' + report.stage + ',' +
                   csv_number(report.loads.factors[0]) + ',' + point.name +
                   ',' + face;
          for (const auto &faces : {u.global, u.local})
            for (unsigned int i = 0; i < 3; ++i)
              lines += ',' + csv_number(share_of_inner * faces[0][i] +
                                        (1 - share_of_inner) * faces[1][i]);
          lines += '\n';
        };
        add("inner", 1);
        add("outer", 0);
        add("middle", 0.5);
      }
    append(lines);
  }
} // namespace Biface
