// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/model/equations/shell_equations.h>
#include <biface/output/buckling_shapes_file.h>
#include <biface/output/csv.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  BucklingShapesFile::BucklingShapesFile(const std::vector<Stage> &stages,
                                         ResultsDirectory         &directory,
                                         const ShellEquations     &equations)
    : ResultFile("buckling-*.csv", directory, equations)
    , wanted(any_buckling(stages))
  {}


  namespace
  {
    /** The factor by which the largest normal displacement is 1. The sign is
     * that of the first node, by number, with more than half of it. */
    double
    factor_of_shape(const ShellMesh &mesh, const LA::Vector &shape)
    {
      const auto normal = [&](const Node &node) {
        return shape(node.dof(2, MixedElement::mean));
      };
      double largest = 0;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          largest = std::max(largest, std::abs(normal(node)));
      largest = Utilities::MPI::max(largest, mesh.communicator);
      if (largest == 0)
        return 1;

      // an eigenvector has either sign: by the numbers of nodes, it is the same
      // on any number of ranks
      types::global_cell_index first =
        std::numeric_limits<types::global_cell_index>::max();
      double sign = 1;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned && node.number < first &&
            std::abs(normal(node)) > largest / 2)
          {
            first = node.number;
            sign  = (normal(node) > 0 ? 1 : -1);
          }
      const auto of_all = Utilities::MPI::min(first, mesh.communicator);
      sign =
        Utilities::MPI::sum(first == of_all ? sign : 0., mesh.communicator);
      return sign / largest;
    }
  } // namespace


  void
  BucklingShapesFile::write(const StepReport &report, const State & /*state*/)
  {
    const ShellMesh        &mesh    = equations.mesh;
    const ReferenceSurface &surface = mesh.get_surface();
    const auto             &modes   = report.buckling->modes;
    for (unsigned int i = 0; i < modes.size(); ++i)
      {
        const LA::Vector &shape  = modes[i].shape;
        const double      factor = factor_of_shape(mesh, shape);
        Rows              rows;
        for (const Node &node : mesh.nodes)
          if (node.locally_owned)
            {
              rows.push_back({chart_coordinate(surface, node, 0),
                              chart_coordinate(surface, node, 1),
                              factor * shape(node.dof(2, MixedElement::mean))});
              // the first line again after a full turn, where the chart ends
              if (mesh.grid.closed && node.grid_index[1] == 0)
                {
                  rows.push_back(rows.back());
                  rows.back()[1] +=
                    surface.get_periodicity()[1] / surface.coordinate_unit(1);
                }
            }
        write_csv(directory.path(
                    "buckling-" + Utilities::int_to_string(report.step, 4) +
                    "-" + Utilities::int_to_string(i + 1, 3) + ".csv"),
                  "alpha_1,alpha_2,value",
                  rows,
                  communicator);
      }
  }
} // namespace Biface
