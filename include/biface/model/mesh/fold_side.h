// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_fold_side_h
#define biface_model_mesh_fold_side_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Biface
{
  /** A side of a mesh from a file at which parts of the shell meet at an angle
   * or a hinge, see QuadrilateralMesh::Fold. Each part has nodes of its own,
   * whose points on the reference surface have the same displacements. */
  struct FoldSide
  {
    /** A cell that meets the others at the side. */
    struct Part
    {
      /** The positions of its nodes in ShellMesh::nodes, at both ends. The
       * first end is the same one for all parts. */
      std::array<unsigned int, 2> nodes;
      /** The position of its wall in ShellMesh::strips. */
      unsigned int strip;
      /** The direction across the side in the axes of its plies, a unit
       * vector. */
      dealii::Tensor<1, 2> across;
      /** Whether the side runs counterclockwise around the cell from the second
       * end to the first. */
      bool is_reversed;
    };
    std::vector<Part> parts;
    /** Unit: length. */
    double length;
    /** The moment per length and angle between the parts; infinite if they are
     * joined rigidly, zero at a hinge. Unit: force. */
    double stiffness;
    /** Pairs of positions in @p parts whose inner, or outer, faces bound one
     * wedge between them, see QuadrilateralMesh::Fold. */
    std::array<std::vector<std::array<unsigned int, 2>>, 2> wedges;
  };
} // namespace Biface

#endif
