// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_chart_grid_h
#define biface_surface_chart_grid_h

#include <deal.II/grid/tria.h>

#include <array>
#include <string>
#include <vector>

namespace Biface
{
  class ReferenceSurface;

  /** Distribution of the cells over the ranks. */
  enum class MeshDistribution
  {
    /** Every rank stores all cells. */
    shared,
    /** Every rank stores its own cells and their neighbors; the first rank
     * stores all cells during set-up. */
    distributed
  };


  /** The edges of a grid, @f$\alpha_1@f$ = min, max and @f$\alpha_2@f$ = min,
   * max, with their boundary indicators. */
  enum class Edge : dealii::types::boundary_id
  {
    alpha_1_min = 0,
    alpha_1_max = 1,
    alpha_2_min = 2,
    alpha_2_max = 3
  };


  /** The indices (i, j) of a node, which are the positions in ChartGrid::lines
   * of the lines that meet there, or of a cell, those of the lines below and to
   * the left of it. */
  using GridIndex = std::array<unsigned int, 2>;


  /**
   * A structured, graded grid in the coordinates of a surface: the rectangle
   * spanned by two lists of coordinate lines, or a ring if the second
   * coordinate is closed.
   *
   * Cells and nodes are numbered lexicographically, with the first coordinate
   * running fastest.
   */
  struct ChartGrid
  {
    /** The entries of a grid, see grid_parameters.h. */
    struct Parameters;

    /** The coordinates of the grid lines in ascending order, in the internal
     * unit of the surface. Empty for a mesh without lines, on a surface that
     * has no coordinates. */
    std::array<std::vector<double>, 2> lines;

    /** Whether the last line of the second coordinate is the first one. */
    bool closed = false;

    MeshDistribution distribution = MeshDistribution::shared;

    /** Whether there are lines. */
    bool
    has_lines() const
    {
      return !lines[0].empty();
    }

    /**
     * The grid with the lines of the intervals on a surface.
     *
     * Throws InputError if they leave the surface, or if a closed coordinate
     * does not span a full turn.
     */
    ChartGrid(const Parameters &parameters, const ReferenceSurface &surface);

    /** The number of cells along the coordinate @p a. */
    unsigned int
    n_cells(const unsigned int a) const
    {
      return lines[a].size() - 1;
    }

    /** The number of nodes along the coordinate @p a: one per line; in a closed
     * coordinate the last line is the first one. */
    unsigned int
    n_nodes(const unsigned int a) const
    {
      return (a == 1 && closed) ? n_cells(a) : lines[a].size();
    }

    dealii::types::global_cell_index
    cell_number(const GridIndex &cell) const
    {
      return cell[0] +
             static_cast<dealii::types::global_cell_index>(n_cells(0)) *
               cell[1];
    }

    dealii::types::global_cell_index
    node_number(const GridIndex &node) const
    {
      return node[0] +
             static_cast<dealii::types::global_cell_index>(n_nodes(0)) *
               node[1];
    }

    /** The indices of the cell with a number, the inverse of cell_number(). */
    GridIndex
    cell_index(const dealii::types::global_cell_index number) const
    {
      return {{static_cast<unsigned int>(number % n_cells(0)),
               static_cast<unsigned int>(number / n_cells(0))}};
    }

    /** The node at a vertex of a cell, numbered as in deal.II. */
    GridIndex
    node_of_cell(const GridIndex &cell, const unsigned int vertex) const
    {
      return {{cell[0] + (vertex & 1), (cell[1] + (vertex >> 1)) % n_nodes(1)}};
    }

    /** The coordinates of a node. */
    dealii::Point<2>
    alpha(const GridIndex &node) const
    {
      return dealii::Point<2>(lines[0][node[0]], lines[1][node[1]]);
    }

    /** Whether a node lies on an edge. */
    bool
    on_edge(const GridIndex &node, const Edge edge) const
    {
      const unsigned int face = static_cast<unsigned int>(edge);
      const unsigned int a    = face / 2;
      if (a == 1 && closed)
        return false;
      return node[a] == (face % 2 == 0 ? 0 : n_cells(a));
    }

    /**
     * Every second line of this grid and the lines that must be kept. A
     * coordinate with fewer than four cells keeps all its lines.
     *
     * @param kept coordinates of the lines that must be kept.
     */
    ChartGrid
    coarsened(const std::array<std::vector<double>, 2> &kept) const;
  };


  /** The names of the edges in parameter files, indexed by Edge. */
  const std::array<std::string, 4> edge_names{
    {"alpha_1 min", "alpha_1 max", "alpha_2 min", "alpha_2 max"}};

  /** The edge of the given name. Throws InputError that names @p entry and
   * @p text if there is none. */
  Edge
  parse_edge(const std::string &entry,
             const std::string &text,
             const std::string &name);


  /** The coordinate along the short sides of the most elongated cell. */
  unsigned int
  short_coordinate(const ReferenceSurface &surface, const ChartGrid &grid);


  /**
   * Create a triangulation of the grid on the surface. The first reference
   * coordinate of each cell is along @f$\alpha_1@f$, the second along
   * @f$\alpha_2@f$; the ids of the coarse cells are ChartGrid::cell_number(),
   * the boundary indicators are those of Edge, and the surface is attached as
   * the manifold of all objects: the sides of all cells are coordinate lines,
   * as required by the element, also after refinement.
   *
   * A parallel triangulation is partitioned by its own settings.
   */
  void
  create_triangulation(const ReferenceSurface      &surface,
                       const ChartGrid             &grid,
                       dealii::Triangulation<2, 3> &triangulation);


  /**
   * Distribute the cells of a triangulation created by create_triangulation()
   * among ranks: whole grid lines along short_coordinate(), which elimination
   * along lines needs; by METIS if there are fewer lines than @p n_ranks.
   */
  void
  partition_triangulation(const ReferenceSurface      &surface,
                          const ChartGrid             &grid,
                          const unsigned int           n_ranks,
                          dealii::Triangulation<2, 3> &triangulation);
} // namespace Biface

#endif
