// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_contributions_of_layers_h
#define biface_model_mesh_contributions_of_layers_h

#include <array>
#include <vector>

#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The contributions of the layers at a node to the whole wall beside it,
   * over which displacements are linear in the height.
   * @param own the heights of its two faces. */
  std::vector<Cell::Contribution>
  contributions_to_wall(const Node &node, const std::array<double, 2> &own);

  /** The contributions of the layers at a node to a layer beside it. Where a
   * ply ends, the heights of the faces there are not those of the node. The
   * stiffest layer goes on along its director; the others remain connected
   * with it, each with its own director.
   * @param own the heights of all faces beside the node. */
  std::vector<Cell::Contribution>
  contributions_to_layer(const Node                &node,
                         const std::vector<double> &own,
                         const unsigned int         stiffest,
                         const unsigned int         layer);
} // namespace Biface

#endif
