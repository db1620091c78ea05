// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_symmetry_h
#define biface_model_equations_symmetry_h

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** Arbitrary displacements of the nodes, different for each @p seed, zero
   * where supports prescribe them, the same on any number of ranks. */
  LA::Vector
  arbitrary_displacements(const ShellMesh &mesh, const unsigned int seed);

  /** A bound of the round-off in the product
   * @f$\mathbf x^T\mathbf K\mathbf x@f$. */
  double
  roundoff(const ShellMesh        &mesh,
           const LA::SparseMatrix &K,
           const LA::Vector       &x);

  /** Whether a tangent is symmetric up to round-off, in the time of a few
   * products with vectors. */
  bool
  is_symmetric(const ShellMesh &mesh, const LA::SparseMatrix &K);
} // namespace Biface

#endif
