// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_divide_mesh_h
#define biface_surface_divide_mesh_h

#include <string>
#include <vector>

namespace Biface
{
  struct MeshOptions;
  struct MeshText;

  /**
   * Prepare what a file says for a mesh: unite nodes that are close to each
   * other, move the nodes to the known surface, and divide the cells as often
   * as the options say. A triangle is divided into three quadrilaterals, a
   * quadrilateral into four, a line into two; the parts belong to the same
   * groups. The new nodes in the middle of sides and cells are on the known
   * surface, if there is one. A set of nodes gets those on the free sides and
   * folds between its nodes, and others unless they are between nodes of such
   * sides and beside no cell inside the set.
   *
   * Throws InputError if nodes that are united belong to one cell, if a node of
   * the file is not on the known surface within a tenth of its shortest side,
   * if none is found for a new one, or if there would be too many cells.
   *
   * @param name that of the mesh, for messages.
   * @return sentences about sets that may be meant otherwise.
   */
  std::vector<std::string>
  prepare_mesh(MeshText          &mesh,
               const MeshOptions &options,
               const std::string &name);
} // namespace Biface

#endif
