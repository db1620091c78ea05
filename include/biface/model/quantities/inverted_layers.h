// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_inverted_layers_h
#define biface_model_quantities_inverted_layers_h

#include <deal.II/base/types.h>

#include <optional>

#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  struct State;


  /** A layer whose outer face lies below its inner face at a vertex of a cell.
   */
  struct InvertedLayer
  {
    /** The number of the cell in the grid, see ChartGrid::cell_number(). */
    dealii::types::global_cell_index cell;
    unsigned int                     layer;
  };

  /**
   * A layer that is turned inside out, or nothing: a shape that Green's
   * strains, which are quadratic in the director, do not distinguish from the
   * one with the opposite director. Of several, that in the first cell. In
   * linear strain theory there are none, and a single layer is not examined: a
   * fold may crush it on the way to a sound shape. The same on all ranks, on
   * which it must be called.
   */
  std::optional<InvertedLayer>
  find_inverted_layer(const ShellMesh &mesh, const State &state);
} // namespace Biface

#endif
