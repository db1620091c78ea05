// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_chart_grid_h
#define biface_surface_chart_grid_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <string>
#include <vector>

#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** Which rank holds which cells. */
  enum class MeshDistribution
  {
    /** Every rank holds all of them. */
    shared,
    /** Every rank holds its own and their neighbors; the first one holds all
     * of them while they are handed out. */
    distributed
  };


  /** A node of a grid by the lines that meet there, (i, j), or a cell by the
   * lines below and left of it: the position of the line of each coordinate in
   * ChartGrid::lines. */
  using GridIndex = std::array<unsigned int, 2>;


  /**
   * A structured, graded grid in the coordinates of a surface: the rectangle
   * spanned by two lists of coordinate lines, or a ring of it where the second
   * coordinate closes.
   *
   * Cells and nodes are numbered lexicographically, with the first coordinate
   * running fastest.
   */
  struct ChartGrid
  {
    struct Parameters
    {
      std::array<std::string, 2> intervals{
        {"-120:-45:12, -45:45:18, 45:120:12",
         "-180:-15:11:smooth, -15:15:18, 15:180:11:smooth"}};
      bool             closed       = true;
      MeshDistribution distribution = MeshDistribution::shared;
      /** How many coarser meshes the run begins with, see coarsened(). */
      unsigned int n_coarse = 0;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Coordinates of the grid lines, rising, in the surface's internal unit.
     */
    std::array<std::vector<double>, 2> lines;

    /** The last line of the second coordinate is its first one. */
    bool closed = false;

    MeshDistribution distribution = MeshDistribution::shared;

    /**
     * Read the interval lists in the units of @p surface.
     *
     * Throws InputError as parse_intervals() does, and where a closed
     * coordinate does not span a full turn.
     */
    ChartGrid(const Parameters &parameters, const ReferenceSurface &surface);

    /** Cells along the coordinate @p a. */
    unsigned int
    n_cells(const unsigned int a) const
    {
      return lines[a].size() - 1;
    }

    /** Nodes along the coordinate @p a: one on each line, where the last line
     * is not the first one. */
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

    /** The inverse of cell_number(). */
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

    /**
     * Every second line of this grid, and those at which something is that the
     * coarser grid must have, too. A coordinate of fewer than four cells keeps
     * its lines.
     *
     * @param kept coordinates of such lines.
     */
    ChartGrid
    coarsened(const std::array<std::vector<double>, 2> &kept) const;
  };


  /** Boundary indicators of the edges of a grid: the edges
   * @f$\alpha_1@f$ = min, max and @f$\alpha_2@f$ = min, max. */
  enum class Edge : dealii::types::boundary_id
  {
    alpha_1_min = 0,
    alpha_1_max = 1,
    alpha_2_min = 2,
    alpha_2_max = 3
  };


  /** The names of the edges in parameter files, indexed by Edge. */
  const std::array<std::string, 4> edge_names{
    {"alpha_1 min", "alpha_1 max", "alpha_2 min", "alpha_2 max"}};


  /**
   * Build the grid as a triangulation on the surface. The first reference
   * coordinate of each cell is that of @f$\alpha_1@f$, the second that of
   * @f$\alpha_2@f$, the ids of the coarse cells are
   * ChartGrid::cell_number(), the boundary indicators are those of Edge, and
   * the surface is attached as the manifold of all objects: the sides of all
   * cells are coordinate lines, as the element needs it, also after refinement.
   *
   * A parallel triangulation is partitioned by its own settings.
   */
  void
  create_triangulation(const ReferenceSurface      &surface,
                       const ChartGrid             &grid,
                       dealii::Triangulation<2, 3> &triangulation);
} // namespace Biface

#endif
