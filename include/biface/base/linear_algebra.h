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


  /** The locally owned entries of a vector that can be read beyond them. */
  inline LA::Vector
  owned_part(const LA::Vector &ghosted)
  {
    LA::Vector owned(ghosted.locally_owned_elements(),
                     ghosted.get_mpi_communicator());
    owned = ghosted;
    return owned;
  }
} // namespace Biface

#endif
