// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_gaps_at_folds_h
#define biface_model_forces_gaps_at_folds_h

#include <vector>

#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** A gap between the faces of parts that meet at a fold, or at the corner
   * between three folds or more: with the gaps, the faces are closed. */
  struct GapAtFold
  {
    /** Between the four nodes of a strip, counterclockwise like those of cells;
     * a triangle has its first three vertices, and an unknown of another node
     * at the fourth one. */
    Cell element;
    bool is_triangle;

    /** The unknowns of the element for FollowerPressure, in whose geometry the
     * last two vertices of a triangle are the same. */
    MixedElement::NodalVector
    displacements(const MixedElement::NodalVector &V) const;

    /** The forces, or other derivatives, of FollowerPressure as those on the
     * unknowns of the element. */
    MixedElement::NodalVector
    at_unknowns(const MixedElement::NodalVector &force) const;

    /** Add the derivative of the forces. */
    void
    add_at_unknowns(const MixedElement::NodalMatrix &derivative,
                    MixedElement::NodalMatrix       &K) const;
  };

  /** The gaps of this rank between the inner or the outer faces. */
  std::vector<GapAtFold>
  gaps_at_folds(const ShellMesh &mesh, const unsigned int face);
} // namespace Biface

#endif
