// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <biface/laminate/material.h>
#include <biface/output/csv.h>
#include <biface/output/results_writer.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Where in a ply the i-th of n points lies, as a fraction of its
     * thickness. */
    double
    height_of(const unsigned int i, const unsigned int n)
    {
      return n == 1 ? 0.5 : static_cast<double>(i) / (n - 1);
    }
  } // namespace


  void
  ResultsWriter::append_probes(const StepReport &report,
                               const State      &state) const
  {
    const ShellMesh &mesh = equations.mesh;

    std::string text;
    for (const NamedPoint &point : mesh.points)
      {
        // x, y, z, then 1, 2, 3 of both faces, from the rank that owns the node
        std::array<std::vector<double>, 2> u{
          {std::vector<double>(6), std::vector<double>(6)}};
        const unsigned int n = mesh.node_of_point("Points", point.name);
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
          Utilities::MPI::sum(values, mesh.communicator, values);

        const auto append = [&](const std::string &face,
                                const double       share_of_inner) {
          text += std::to_string(report.step) + ',' + report.stage + ',' +
                  csv_number(report.loads.factor) + ',' + point.name + ',' +
                  face;
          for (unsigned int i = 0; i < 6; ++i)
            text += ',' + csv_number(share_of_inner * u[0][i] +
                                     (1 - share_of_inner) * u[1][i]);
          text += '\n';
        };
        append("inner", 1);
        append("outer", 0);
        append("middle", 0.5);
      }
    write_text(path("probes.csv"), text, true, mesh.communicator);
  }


  void
  ResultsWriter::write_plies(const StepReport &report, const State &state) const
  {
    const ShellMesh   &mesh      = equations.mesh;
    const auto        &all_plies = mesh.layup.get_plies();
    const unsigned int n_heights = parameters.points_per_ply;
    const auto         names     = ply_value_names(parameters.criteria);

    // of each height: angle, height over the reference surface, tension along
    // the fibers, then the values; in front, how many cells gave them
    const unsigned int n_columns = 3 + names.size();
    std::string text = "name,ply,material,fraction,angle,height,fiber_tension";
    for (const std::string &name : names)
      text += ',' + name;
    text += '\n';

    for (const NamedPoint &point : mesh.points)
      {
        const unsigned int  n = mesh.node_of_point("Points", point.name);
        std::vector<double> sums(all_plies.size() *
                                 (1 + n_heights * n_columns));
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          {
            const Cell &cell = mesh.cells[c];
            const auto  v = std::find(cell.nodes.begin(), cell.nodes.end(), n) -
                           cell.nodes.begin();
            if (v == 4)
              continue;
            const Laminate &laminate = mesh.strips[cell.strip].at_lines[v & 1];
            const Resultants::Vector E =
              Modes::at_vertices(equations.total_strains(state, c))[v];

            double height = laminate.faces()[0];
            for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
              {
                const Ply &ply = laminate.get_plies()[p];
                double *sum = &sums[ply.number * (1 + n_heights * n_columns)];
                *sum++ += 1;
                // the stress is linear over the ply
                const double tension =
                  ply.thickness *
                  rotate_about_normal(PlyState(laminate, p, 0.5, E).stress,
                                      -ply.angle)[0][0];
                for (unsigned int i = 0; i < n_heights; ++i)
                  {
                    const double fraction = height_of(i, n_heights);
                    *sum++ += ply.angle * 180 / numbers::PI;
                    *sum++ += height + fraction * ply.thickness;
                    *sum++ += tension;
                    for (const double value :
                         ply_values(PlyState(laminate, p, fraction, E),
                                    ply.angle,
                                    all_plies[ply.number],
                                    parameters.criteria))
                      *sum++ += value;
                  }
                height += ply.thickness;
              }
          }
        Utilities::MPI::sum(sums, mesh.communicator, sums);

        for (unsigned int p = 0; p < all_plies.size(); ++p)
          {
            const double *sum     = &sums[p * (1 + n_heights * n_columns)];
            const double  n_cells = *sum++;
            for (unsigned int i = 0; n_cells > 0 && i < n_heights; ++i)
              {
                text += point.name + ',' + std::to_string(p + 1) + ',' +
                        all_plies[p].material + ',' +
                        csv_number(height_of(i, n_heights));
                for (unsigned int k = 0; k < n_columns; ++k, ++sum)
                  text += ',' + (std::isnan(*sum) ? std::string()
                                                  : csv_number(*sum / n_cells));
                text += '\n';
              }
          }
      }
    write_text(
      path("plies-" + Utilities::int_to_string(report.step, 4) + ".csv"),
      text,
      false,
      mesh.communicator);
  }
} // namespace Biface
