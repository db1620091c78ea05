// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_cell_maximum_h
#define biface_model_mesh_cell_maximum_h

#include <deal.II/base/types.h>

#include <limits>
#include <optional>
#include <vector>

#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The cell of a mesh, and its layer, in which a value is largest. Values
   * within 1e-6 of the largest are taken as equal, so that round-off does not
   * decide between places that mirror each other; of these it is the element
   * with the lowest number, on any number of ranks. */
  struct CellMaximum
  {
    /** The value of a cell that has none. */
    static constexpr double none = -std::numeric_limits<double>::infinity();
    /** The relative difference of values that are taken as equal: well above
     * the round-off of a solution, below what matters. */
    static constexpr double tolerance = 1e-6;

    /** The largest value of all cells. */
    double value = none;
    /** The number of the cell in the grid, see ChartGrid::cell_number(). */
    dealii::types::global_cell_index number = 0;

    /** The layer, from the inner face. */
    unsigned int layer = 0;
    /** The position of the element among those of this rank, set on the one
     * rank that owns it. */
    std::optional<unsigned int> position;

    /** The minimum value that is taken as equal to the largest. */
    double
    bound() const
    {
      return value - tolerance * (value < 0 ? -value : value);
    }
  };

  /** Find the cell with the largest value among all ranks; nothing if no cell
   * has a value. Must be called on all ranks.
   * @param values of the elements of this rank, see ShellMesh::cells. */
  std::optional<CellMaximum>
  find_cell_maximum(const ShellMesh &mesh, const std::vector<double> &values);
} // namespace Biface

#endif
