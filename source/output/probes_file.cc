// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <array>
#include <vector>

#include <biface/output/csv.h>
#include <biface/output/probes_file.h>

namespace Biface
{
  using namespace dealii;

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
    const ShellMesh &mesh = equations.mesh;

    std::string lines;
    for (const NamedPoint &point : mesh.points)
      {
        // x, y, z, then 1, 2, 3 of both faces, from the rank that owns the node
        std::array<std::vector<double>, 2> u{
          {std::vector<double>(6), std::vector<double>(6)}};
        const unsigned int n = mesh.node_of_point("Named points", point.name);
        if (n != numbers::invalid_unsigned_int && mesh.nodes[n].locally_owned)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const Node        &node = mesh.nodes[n];
              const Tensor<1, 3> local =
                mesh.displacement(state.displacement, node, face);
              const Tensor<1, 3> global = node.surface.from_frame(local);
              for (unsigned int i = 0; i < 3; ++i)
                {
                  u[face][i]     = global[i];
                  u[face][3 + i] = local[i];
                }
            }
        for (auto &values : u)
          Utilities::MPI::sum(values, communicator, values);

        const auto add = [&](const std::string &face,
                             const double       share_of_inner) {
          lines += std::to_string(report.step) + ',' + report.stage + ',' +
                   csv_number(report.loads.factor) + ',' + point.name + ',' +
                   face;
          for (unsigned int i = 0; i < 6; ++i)
            lines += ',' + csv_number(share_of_inner * u[0][i] +
                                      (1 - share_of_inner) * u[1][i]);
          lines += '\n';
        };
        add("inner", 1);
        add("outer", 0);
        add("middle", 0.5);
      }
    append(lines);
  }
} // namespace Biface
