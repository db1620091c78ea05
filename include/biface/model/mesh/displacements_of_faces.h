// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_displacements_of_faces_h
#define biface_model_mesh_displacements_of_faces_h

#include <deal.II/base/tensor.h>

#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/mesh_nodes.h>

namespace Biface
{
  /** Set the unknowns of a node to displacements of its faces, or to their
   * velocities.
   * @param of_faces from the inner to the outer face, one more than layers, in
   * the frame of the node.
   * @param vector locally owned entries; not compressed. */
  inline void
  set_displacements_of_faces(const Node                              &node,
                             const std::vector<dealii::Tensor<1, 3>> &of_faces,
                             LA::Vector                              &vector)
  {
    // the mean of the outermost faces, and half the differences over the layers
    for (unsigned int i = 0; i < 3; ++i)
      {
        vector(node.dof(i, 0)) = (of_faces.front()[i] + of_faces.back()[i]) / 2;
        for (unsigned int part = 1; part < node.n_parts(); ++part)
          vector(node.dof(i, part)) =
            (of_faces[part][i] - of_faces[part - 1][i]) / 2;
      }
  }
} // namespace Biface

#endif
