// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_by_gcc_h
#define biface_tests_by_gcc_h

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

/**
 * Functions of deal.II with `enable_if` in their declarations, which clang and
 * GCC name differently. A test that clang compiles calls them through these
 * functions, which GCC compiles, as it does deal.II.
 */
namespace ByGCC
{
  void
  reinit(dealii::TrilinosWrappers::SparseMatrix &matrix,
         const dealii::IndexSet                 &rows,
         const dealii::IndexSet                 &columns,
         const dealii::DynamicSparsityPattern   &pattern,
         MPI_Comm                                communicator,
         bool                                    exchange_data);

  void
  vmult(const dealii::TrilinosWrappers::SparseMatrix &matrix,
        dealii::TrilinosWrappers::MPI::Vector        &product,
        const dealii::TrilinosWrappers::MPI::Vector  &v);

  void
  Tvmult(const dealii::TrilinosWrappers::SparseMatrix &matrix,
         dealii::TrilinosWrappers::MPI::Vector        &product,
         const dealii::TrilinosWrappers::MPI::Vector  &v);
} // namespace ByGCC


#ifdef __clang__
namespace dealii
{
  namespace TrilinosWrappers
  {
    template <>
    inline void
    SparseMatrix::reinit(const IndexSet               &rows,
                         const IndexSet               &columns,
                         const DynamicSparsityPattern &pattern,
                         const MPI_Comm               &communicator,
                         const bool                    exchange_data)
    {
      ByGCC::reinit(*this, rows, columns, pattern, communicator, exchange_data);
    }


    template <>
    inline void
    SparseMatrix::vmult(MPI::Vector &product, const MPI::Vector &v) const
    {
      ByGCC::vmult(*this, product, v);
    }


    template <>
    inline void
    SparseMatrix::Tvmult(MPI::Vector &product, const MPI::Vector &v) const
    {
      ByGCC::Tvmult(*this, product, v);
    }
  } // namespace TrilinosWrappers
} // namespace dealii
#endif

#endif
