// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_rigid_motions_h
#define biface_model_mesh_rigid_motions_h

#include <string>
#include <vector>

#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The infinitesimal rigid motions that the supports leave free, in words:
   * "translation along y", "rotation about x", or "translation along x with
   * rotation about z" for a combination. Rotations are about axes through the
   * mean of all nodes.
   *
   * Such a shell is held only by its loads or by contact, if at all. Must be
   * called on all ranks.
   */
  std::vector<std::string>
  free_rigid_motions(const ShellMesh &mesh);

  /**
   * The six rigid motions of the shell, three translations and three rotations,
   * as nodal displacements: the entries of each for the locally owned degrees
   * of freedom, in their order. Supports are ignored.
   */
  std::vector<std::vector<double>>
  rigid_motions(const ShellMesh &mesh);
} // namespace Biface

#endif
