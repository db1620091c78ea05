// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_linear_algebra_h
#define biface_base_linear_algebra_h

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Biface
{
  /** The linear algebra of the program. */
  namespace LA
  {
    using Vector       = dealii::TrilinosWrappers::MPI::Vector;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  } // namespace LA
} // namespace Biface

#endif
