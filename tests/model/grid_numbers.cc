// SPDX-License-Identifier: LGPL-2.1-or-later

// Nodes lie exactly where the grid lines meet, and cells between them, in the
// order of their numbers: on open and closed grids, for both distributions of
// the mesh, on any number of ranks.

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_accessor.h>

#include <map>

#include <biface/laminate/layup.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/spline_curve.h>
#include <biface/surface/surface_of_revolution.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  check(const std::string &name, const ChartGrid::Parameters &parameters)
  {
    // a meridian whose points are found by Newton's method only
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= 20; ++i)
      points.emplace_back(200 + 50 * std::cos(-2 + 0.2 * i),
                          50 * std::sin(-2 + 0.2 * i));
    auto surface = std::make_unique<SurfaceOfRevolution>(
      std::make_shared<SplineCurve>(points, "meridian"));
    const ChartGrid grid(parameters, *surface);
    const ShellMesh mesh(MPI_COMM_WORLD,
                         std::move(surface),
                         grid,
                         Layup(Layup::Parameters(), cord_ply()),
                         Supports(),
                         {});

    // where the triangulation has its vertices, by their first unknown
    std::map<types::global_dof_index, Point<3>> vertices;
    for (const auto &cell : mesh.get_dof_handler().active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          vertices[cell->vertex_dof_index(v, 0)] = cell->vertex(v);

    double              error = 0;
    std::vector<double> owners(mesh.n_nodes()), cells(mesh.n_cells());
    for (const Node &node : mesh.nodes)
      {
        const unsigned int i = node.number % grid.lines[0].size(),
                           j = node.number / grid.lines[0].size();
        AssertThrow(node.alpha == Point<2>(grid.lines[0][i], grid.lines[1][j]),
                    ExcInternalError());
        error =
          std::max(error,
                   vertices.at(node.dofs[0])
                     .distance(mesh.get_surface().push_forward(node.alpha)));
        if (node.locally_owned)
          owners[node.number] += 1;
      }
    const unsigned int n_1 = grid.lines[0].size() - 1;
    for (const Cell &cell : mesh.cells)
      {
        cells[cell.number] += 1;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const unsigned int i = cell.number % n_1 + v % 2,
                               j = cell.number / n_1 + v / 2;
            AssertThrow(mesh.nodes[cell.nodes[v]].number ==
                          (i + (n_1 + 1) * j) % mesh.n_nodes(),
                        ExcInternalError());
          }
      }
    error = Utilities::MPI::max(error, MPI_COMM_WORLD);
    Utilities::MPI::sum(owners, MPI_COMM_WORLD, owners);
    Utilities::MPI::sum(cells, MPI_COMM_WORLD, cells);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::cout << name << std::endl;
    check_small("  distance of nodes from vertices", error, 1e-13, 200);
    std::cout << "  all numbers occur once: "
              << (owners == std::vector<double>(owners.size(), 1) &&
                  cells == std::vector<double>(cells.size(), 1))
              << std::endl;
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  ChartGrid::Parameters parameters;
  for (const auto distribution :
       {MeshDistribution::shared, MeshDistribution::distributed})
    {
      const std::string name =
        distribution == MeshDistribution::shared ? "shared" : "distributed";
      parameters.distribution = distribution;

      parameters.closed    = true;
      parameters.intervals = {
        {parse_intervals("intervals", "10:100:5:1.3"),
         parse_intervals("intervals", "-170:-100:4, -100:190:9")}};
      check(name + ", closed", parameters);

      // a slit: two nodes at the same place
      parameters.closed    = false;
      parameters.intervals = {{parse_intervals("intervals", "10:100:3"),
                               parse_intervals("intervals", "-180:180:8")}};
      check(name + ", slit", parameters);

      parameters.intervals = {{parse_intervals("intervals", "0:80:1"),
                               parse_intervals("intervals", "350:400:7")}};
      check(name + ", one cell wide, beyond a turn", parameters);
    }
}
