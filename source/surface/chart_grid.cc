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
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::array<std::string, 2> entry_names{
      {"Mesh/Intervals alpha_1", "Mesh/Intervals alpha_2"}};
  }


  void
  ChartGrid::Parameters::add_parameters(ParameterHandler &prm)
  {
    // the default grid is that of the bias tire of the paper
    const std::string form =
      " A comma-separated list of adjoining intervals: 'start:end:n' is n "
      "equal cells, 'start:end:n:q' is n cells each q times as long as the "
      "previous one, 'start:end:n:smooth' is n cells whose lengths continue "
      "those of the adjoining interval geometrically. Start and end may be "
      "formulas, such as 360/7. Unit: degrees for an angle, length otherwise.";
    const std::string with_end =
      " The formulas may contain 'end', the largest alpha_1 of the surface, "
      "such as 0.3*end.";
    add_parsed(prm,
               "Mesh/",
               "Intervals alpha_1",
               intervals[0].text,
               intervals[0],
               parse_intervals,
               "Cells along the first coordinate (the meridian)." + form +
                 with_end);
    add_parsed(prm,
               "Mesh/",
               "Intervals alpha_2",
               intervals[1].text,
               intervals[1],
               parse_intervals,
               "Cells along the second coordinate (around the axis)." + form);
    prm.add_parameter("Closed in alpha_2",
                      closed,
                      "Whether the second coordinate is closed, that is, "
                      "spans a full turn and has no edges.",
                      Patterns::Bool());
    add_choice(prm,
               "Distribution",
               distribution,
               {"shared", "distributed"},
               "Distribution of the cells over the ranks: 'shared' (every "
               "rank stores all cells) or 'distributed' (every rank stores "
               "its own cells and their neighbors, for meshes too large for "
               "one rank). Results are the same.");
    prm.add_parameter("Coarse meshes",
                      n_coarse,
                      "Number of coarser meshes, each with half as many cells "
                      "in both directions as the next, on which the analysis "
                      "is run first. Steps on the finer mesh then start from "
                      "the solution on the coarser one, which takes far fewer "
                      "iterations on fine meshes in contact. Results on "
                      "coarser meshes are not written.",
                      Patterns::Integer(0, 10));
  }


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


  ChartGrid::ChartGrid(const Parameters       &parameters,
                       const ReferenceSurface &surface)
    : closed(parameters.closed), distribution(parameters.distribution)
  {
    for (unsigned int a = 0; a < 2; ++a)
      lines[a] = parameters.intervals[a]
                   .on(surface.end(a))
                   .lines(surface.coordinate_unit(a));
    // the line at 0 lies there exactly, for formulas and messages
    for (std::vector<double> &coordinates : lines)
      for (double &line : coordinates)
        if (std::abs(line) < 1e-12 * (coordinates.back() - coordinates.front()))
          line = 0;

    const std::pair<double, double> range = surface.range();
    const double tolerance = 1e-9 * (lines[0].back() - lines[0].front());
    if (lines[0].front() < range.first - tolerance ||
        lines[0].back() > range.second + tolerance)
      throw InputError(
        entry_names[0],
        parameters.intervals[0].text,
        "alpha_1 of the surface runs from " +
          number_to_string(range.first / surface.coordinate_unit(0)) + " to " +
          number_to_string(range.second / surface.coordinate_unit(0)));

    const double period = surface.get_periodicity()[1];
    if (period > 0)
      {
        if (lines[1].back() - lines[1].front() > period * (1 + 1e-12))
          throw InputError(entry_names[1],
                           parameters.intervals[1].text,
                           "it must not span more than 360 degrees");
        for (unsigned int j = 1; j < lines[1].size(); ++j)
          if (!(lines[1][j] - lines[1][j - 1] < 0.49 * period))
            throw InputError(entry_names[1],
                             parameters.intervals[1].text,
                             "each cell must span less than 176 degrees");
      }
    if (static_cast<double>(lines[0].size()) * lines[1].size() > 3e8)
      throw InputError(entry_names[0],
                       parameters.intervals[0].text,
                       "the mesh must have fewer than 300 million nodes");

    if (closed)
      {
        const double turn = surface.get_periodicity()[1];
        const double span = lines[1].back() - lines[1].front();
        if (turn == 0 || std::abs(span - turn) > 1e-12 * turn)
          throw InputError(entry_names[1],
                           parameters.intervals[1].text,
                           "a closed coordinate must span 360 degrees");
        if (lines[1].size() < 4)
          throw InputError(entry_names[1],
                           parameters.intervals[1].text,
                           "a closed coordinate needs at least 3 cells");
      }
  }


  ChartGrid
  ChartGrid::coarsened(const std::array<std::vector<double>, 2> &kept) const
  {
    ChartGrid coarse(*this);
    for (unsigned int a = 0; a < 2; ++a)
      {
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
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const GridIndex index =
          grid.cell_index(cell->id().get_coarse_cell_id());
        cell->set_subdomain_id(index[across] * n_ranks / n_lines);
      }
  }
} // namespace Biface
