// SPDX-License-Identifier: LGPL-2.1-or-later

#include "by_gcc.h"

using namespace dealii;

namespace ByGCC
{
  void
  reinit(TrilinosWrappers::SparseMatrix &matrix,
         const IndexSet                 &rows,
         const IndexSet                 &columns,
         const DynamicSparsityPattern   &pattern,
         const MPI_Comm                  communicator,
         const bool                      exchange_data)
  {
    matrix.reinit(rows, columns, pattern, communicator, exchange_data);
  }


  void
  vmult(const TrilinosWrappers::SparseMatrix &matrix,
        TrilinosWrappers::MPI::Vector        &product,
        const TrilinosWrappers::MPI::Vector  &v)
  {
    matrix.vmult(product, v);
  }


  void
  Tvmult(const TrilinosWrappers::SparseMatrix &matrix,
         TrilinosWrappers::MPI::Vector        &product,
         const TrilinosWrappers::MPI::Vector  &v)
  {
    matrix.Tvmult(product, v);
  }
} // namespace ByGCC
