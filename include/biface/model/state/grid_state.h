// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_grid_state_h
#define biface_model_state_grid_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

#include <biface/element/modes.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/surface/chart_grid.h>

namespace Biface
{
  struct State;


  /**
   * A state stored by grid lines, which can be evaluated at any position of the
   * surface and on any rank, independently of the distribution of its mesh.
   * Displacements since the stress-free state are interpolated bilinearly, with
   * components in the frame of the surface; resultants are those of each cell
   * and layer.
   */
  class GridState
  {
  public:
    /** The undeformed state of a grid. */
    explicit GridState(const ChartGrid &grid, const unsigned int n_layers = 1);

    /** The state of a mesh. Must be called on all ranks. */
    GridState(const ShellMesh &mesh, const State &state);

    /** The part @p part of the unknowns of a node, see Node::n_parts(), at a
     * position within the grid. Unit: length. */
    dealii::Tensor<1, 3>
    displacement(const dealii::Point<2> &alpha, const unsigned int part) const;

    /** The indicator of contact: 1 at active nodes, 0 at the others, bilinear
     * in between. */
    double
    contact(const dealii::Point<2> &alpha) const;

    /** The modes of the resultants of a layer in a cell with the given vertices
     * that lies within a cell of this grid. */
    Modes::Vector
    resultants(const std::array<dealii::Point<2>, 4> &vertices,
               const unsigned int                     layer) const;

  private:
    /** A cell of the grid, and reference coordinates from 0 to 1 in it. */
    struct Place
    {
      GridIndex        cell;
      dealii::Point<2> xi;
    };

    Place
    place(const dealii::Point<2> &alpha) const;

    template <typename T>
    T
    interpolate(const T *values, const Place &place) const;

    ChartGrid    grid;
    unsigned int n_layers;
    /** The unknowns, part by part, by node numbers. */
    std::vector<dealii::Tensor<1, 3>> displacements;
    /** The indicators of contact by node numbers. */
    std::vector<double> contacts;
    /** The resultants by cell numbers, layer by layer. */
    std::vector<Modes::Vector> resultants_of_layers;
  };
} // namespace Biface

#endif
