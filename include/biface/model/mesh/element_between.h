// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_element_between_h
#define biface_model_mesh_element_between_h

#include <array>

namespace Biface
{
  struct Cell;
  class ShellMesh;

  /** An element without a stiffness between four nodes of this rank, which need
   * not belong to a cell; its faces are those of the wall at the nodes, and its
   * geometry consists of the vertices and of the faces for
   * FollowerPressure. */
  Cell
  element_between(const ShellMesh                   &mesh,
                  const std::array<unsigned int, 4> &nodes);
} // namespace Biface

#endif
