// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_grid_state_h
#define biface_model_grid_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

#include <biface/element/modes.h>
#include <biface/model/shell_mesh.h>
#include <biface/model/state.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  /**
   * A state by the lines of its grid, to be read at any place of the surface
   * and on any rank, whatever its mesh was distributed like. Displacements are
   * bilinear between the nodes, in the frames of the surface; resultants are
   * the functions of each cell.
   */
  class GridState
  {
  public:
    /** The undeformed state of a grid. */
    explicit GridState(const ChartGrid &grid);

    /** To be called on all ranks alike. */
    GridState(const ShellMesh &mesh, const State &state);

    /** The displacements @f$v_1^-,v_1^+,v_2^-,v_2^+,v_3^-,v_3^+@f$ at a place
     * within the grid. Unit: length. */
    dealii::Tensor<1, 6>
    displacement(const dealii::Point<2> &alpha) const;

    /** How much of a place is in contact: 1 at active nodes, 0 at the others,
     * bilinear between them. */
    double
    contact(const dealii::Point<2> &alpha) const;

    /** Resultants at the vertices of a cell that lies within one of this
     * grid's, as its modes. */
    Modes::Vector
    resultants(const std::array<dealii::Point<2>, 4> &vertices) const;

  private:
    /** A cell of the grid, and where in it: reference coordinates from 0 to 1.
     */
    struct Place
    {
      GridIndex        cell;
      dealii::Point<2> xi;
    };

    Place
    place(const dealii::Point<2> &alpha) const;

    template <typename T>
    T
    interpolate(const std::vector<T> &values, const Place &place) const;

    ChartGrid grid;
    /** By the numbers of nodes. */
    std::vector<dealii::Tensor<1, 6>> displacements;
    std::vector<double>               contacts;
    /** By the numbers of cells. */
    std::vector<Modes::Vector> cell_resultants;
  };
} // namespace Biface

#endif
