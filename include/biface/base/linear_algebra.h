// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_linear_algebra_h
#define biface_base_linear_algebra_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>

#include <cmath>

namespace Biface
{
  /** The linear algebra of the program. */
  namespace LA
  {
    using Vector       = dealii::TrilinosWrappers::MPI::Vector;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  } // namespace LA


  /** Replace a small matrix, which may be empty, by its inverse.
   * @return whether it is regular; if not, it is unchanged. */
  bool
  invert(dealii::FullMatrix<double> &matrix);


  /** The locally owned entries of a vector that can be read beyond them. */
  inline LA::Vector
  owned_part(const LA::Vector &ghosted)
  {
    LA::Vector owned(ghosted.locally_owned_elements(),
                     ghosted.get_mpi_communicator());
    owned = ghosted;
    return owned;
  }


  /** The entries of a vector in the order of the columns of a matrix on this
   * rank, from the ranks that own them. Must be called on all ranks. */
  inline Epetra_Vector
  at_columns(const LA::SparseMatrix &A, const LA::Vector &x)
  {
    const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
    Epetra_Vector           owned(epetra.DomainMap());
    for (int k = 0; k < owned.MyLength(); ++k)
      owned[k] = x(owned.Map().GID(k));
    if (epetra.Importer() == nullptr)
      return owned;
    Epetra_Vector entries(epetra.ColMap());
    entries.Import(owned, *epetra.Importer(), Insert);
    return entries;
  }


  /** The sum of @f$|A_{ij}x_j|@f$ over a row, to which the round-off of the
   * product is proportional.
   * @param row the local number of the row.
   * @param x the entries at the columns of this rank, see at_columns(). */
  inline double
  absolute_product(const LA::SparseMatrix &A,
                   const int               row,
                   const Epetra_Vector    &x)
  {
    const Epetra_CrsMatrix &epetra = A.trilinos_matrix();
    int                     n_entries;
    double                 *values;
    int                    *columns;
    epetra.ExtractMyRowView(row, n_entries, values, columns);
    double sum = 0;
    for (int k = 0; k < n_entries; ++k)
      sum += std::abs(values[k] * x[columns[k]]);
    return sum;
  }
} // namespace Biface

#endif
