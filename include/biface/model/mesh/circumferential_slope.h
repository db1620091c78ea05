// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_circumferential_slope_h
#define biface_model_mesh_circumferential_slope_h

#include <deal.II/base/tensor.h>

#include <array>
#include <utility>

#include <biface/element/mixed_element.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The derivative of the positions of a face by the angle around the axis of
   * a surface of revolution, at a vertex of a cell, in the frame of the
   * vertex: @f$\mathbf x'=A_2(\zeta_2\mathbf e_2+\mathbf v_{,2}/A_2)@f$, with
   * the rotation of the frame. It depends on the displacements of the vertex
   * and of its neighbor along the line of the mesh.
   */
  struct CircumferentialSlope
  {
    /** The slope at a vertex of a cell.
     * @param q the vertex; its neighbor is q ^ 2. */
    CircumferentialSlope(const ShellMesh   &mesh,
                         const Cell        &cell,
                         const unsigned int q)
      : q(q)
    {
      const double lame = mesh.nodes[cell.nodes[q]].surface.lame[1];
      const ElementGeometry::Vertex &vertex = cell.geometry.vertices[q];
      neighbor = -lame * vertex.slope[1] * cell.geometry.turn(q, q ^ 2);
      own      = lame * vertex.connection[1];
      for (unsigned int i = 0; i < 3; ++i)
        own[i][i] += lame * vertex.slope[1];
      for (unsigned int face = 0; face < 2; ++face)
        undeformed[face] =
          lame * vertex.metric.zeta[face][1] * vertex.metric.tangents[face][1];
    }

    unsigned int q;
    /** The derivative with respect to the displacement of the vertex. */
    dealii::Tensor<2, 3> own;
    /** The derivative with respect to the displacement of the adjacent vertex.
     */
    dealii::Tensor<2, 3> neighbor;
    /** The slopes of the undeformed faces. */
    std::array<dealii::Tensor<1, 3>, 2> undeformed;

    /** The slope of a deformed face. */
    dealii::Tensor<1, 3>
    of(const MixedElement::NodalVector &V, const unsigned int face) const
    {
      return own * MixedElement::face_displacement(V, q, face) +
             neighbor * MixedElement::face_displacement(V, q ^ 2, face) +
             undeformed[face];
    }

    /** The two vertices on whose displacements the slope depends, with the
     * derivatives. */
    std::array<std::pair<unsigned int, dealii::Tensor<2, 3>>, 2>
    parts() const
    {
      return {{{q, own}, {q ^ 2, neighbor}}};
    }
  };
} // namespace Biface

#endif
