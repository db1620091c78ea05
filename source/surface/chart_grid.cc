// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  Edge
  parse_edge(const std::string &entry,
             const std::string &text,
             const std::string &name)
  {
    const auto found = std::find(edge_names.begin(), edge_names.end(), name);
    if (found == edge_names.end())
      throw InputError(entry,
                       text,
                       "the edges are 'alpha_1 min', 'alpha_1 max', 'alpha_2 "
                       "min', 'alpha_2 max'");
    return static_cast<Edge>(found - edge_names.begin());
  }


  ChartGrid
  ChartGrid::coarsened(const std::array<std::vector<double>, 2> &kept) const
  {
    ChartGrid coarse(*this);
    for (unsigned int a = 0; a < 2; ++a)
      {
        // two cells remain in each direction
        if (lines[a].size() < 5)
          continue;
        const double tolerance = 1e-9 * (lines[a].back() - lines[a].front());
        const auto   is_kept   = [&](const double line) {
          return line == lines[a].back() ||
                 std::any_of(
                   kept[a].begin(), kept[a].end(), [&](const double other) {
                     return std::abs(line - other) <= tolerance;
                   });
        };
        coarse.lines[a].clear();
        bool skipped = true;
        for (const double line : lines[a])
          {
            // every second line, and those without which the coarser shell
            // would be another one
            const bool keep = skipped || is_kept(line);
            if (keep)
              coarse.lines[a].push_back(line);
            skipped = !keep;
          }
      }
    return coarse;
  }


  void
  create_triangulation(const ReferenceSurface &surface,
                       const ChartGrid        &grid,
                       Triangulation<2, 3>    &triangulation)
  {
    std::vector<Point<3>> vertices;
    vertices.reserve(grid.n_nodes(0) * grid.n_nodes(1));
    for (unsigned int j = 0; j < grid.n_nodes(1); ++j)
      for (unsigned int i = 0; i < grid.n_nodes(0); ++i)
        vertices.push_back(surface.push_forward(grid.alpha({{i, j}})));

    std::vector<CellData<2>> cells;
    SubCellData              edges;
    const unsigned int       n_1 = grid.n_cells(0), n_2 = grid.n_cells(1);
    cells.reserve(n_1 * n_2);
    const auto add_edge = [&](const CellData<2> &cell,
                              const unsigned int face) {
      CellData<1> line;
      for (unsigned int v = 0; v < 2; ++v)
        line.vertices[v] =
          cell.vertices[GeometryInfo<2>::face_to_cell_vertices(face, v)];
      line.boundary_id = static_cast<types::boundary_id>(face);
      line.manifold_id = 0;
      edges.boundary_lines.push_back(line);
    };

    // in the order of their numbers, which become the ids of coarse cells
    for (unsigned int j = 0; j < n_2; ++j)
      for (unsigned int i = 0; i < n_1; ++i)
        {
          CellData<2> cell;
          for (unsigned int v = 0; v < 4; ++v)
            cell.vertices[v] = grid.node_number(grid.node_of_cell({{i, j}}, v));
          cell.manifold_id = 0;
          cells.push_back(cell);

          // the faces of a cell are in the order of Edge
          const std::array<bool, 4> at_edge{{i == 0,
                                             i + 1 == n_1,
                                             j == 0 && !grid.closed,
                                             j + 1 == n_2 && !grid.closed}};
          for (unsigned int face = 0; face < 4; ++face)
            if (at_edge[face])
              add_edge(cell, face);
        }

    triangulation.set_manifold(0, surface);
    triangulation.create_triangulation(vertices, cells, edges);
    triangulation.set_all_manifold_ids(0);
  }


  unsigned int
  short_coordinate(const ReferenceSurface &surface, const ChartGrid &grid)
  {
    std::array<double, 2> ratios{};
    for (unsigned int j = 0; j < grid.n_cells(1); ++j)
      for (unsigned int i = 0; i < grid.n_cells(0); ++i)
        {
          const GridIndex       cell{{i, j}};
          Point<2>              middle;
          std::array<double, 2> lengths;
          for (unsigned int a = 0; a < 2; ++a)
            {
              const double *line = &grid.lines[a][cell[a]];
              middle[a]          = (line[0] + line[1]) / 2;
              lengths[a]         = line[1] - line[0];
            }
          const auto   lame  = surface.evaluate(middle).lame;
          const double ratio = lengths[1] * lame[1] / (lengths[0] * lame[0]);
          ratios[0]          = std::max(ratios[0], ratio);
          ratios[1]          = std::max(ratios[1], 1 / ratio);
        }
    return ratios[0] >= ratios[1] ? 0 : 1;
  }


  void
  partition_triangulation(const ReferenceSurface &surface,
                          const ChartGrid        &grid,
                          const unsigned int      n_ranks,
                          Triangulation<2, 3>    &triangulation)
  {
    if (n_ranks == 1)
      return;
    const unsigned int across  = 1 - short_coordinate(surface, grid);
    const unsigned int n_lines = grid.n_cells(across);
    if (n_lines < n_ranks)
      {
        GridTools::partition_triangulation(
          n_ranks, triangulation, SparsityTools::Partitioner::metis);
        return;
      }
    // whole lines along the short sides of the cells, where the smoother of the
    // multigrid solves: none is cut, section 7
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const GridIndex index =
          grid.cell_index(cell->id().get_coarse_cell_id());
        cell->set_subdomain_id(index[across] * n_ranks / n_lines);
      }
  }
} // namespace Biface
