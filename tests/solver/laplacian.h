// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_solver_laplacian_h
#define biface_tests_solver_laplacian_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <cmath>
#include <vector>

#include <biface/base/linear_algebra.h>

using namespace dealii;
using namespace Biface;

/** The seven-point Laplacian on a cube, whose factors are full enough for
 * their use to pay. */
class Laplacian
{
public:
  LA::SparseMatrix matrix;
  LA::Vector       rhs, solution;

  Laplacian()
  {
    const unsigned int n    = side * side * side;
    const unsigned int rank = Utilities::MPI::this_mpi_process(comm);
    const unsigned int size = Utilities::MPI::n_mpi_processes(comm);
    IndexSet           owned(n);
    owned.add_range(n * rank / size, n * (rank + 1) / size);

    DynamicSparsityPattern pattern(n, n, owned);
    for (const auto i : owned)
      for (const auto j : neighbors(i))
        pattern.add(i, j);
    matrix.reinit(owned, pattern, comm);
    rhs.reinit(owned, comm);
    solution.reinit(owned, comm);
    for (const auto i : owned)
      rhs[i] = 1. + i % 5;
    rhs.compress(VectorOperation::insert);
  }

  /** Add the identity times a factor that depends on the place. */
  void
  set(const double shift)
  {
    for (const auto i : rhs.locally_owned_elements())
      for (const auto j : neighbors(i))
        matrix.set(i, j, i == j ? 6 + shift * (1 + i % 7) : -1);
    matrix.compress(VectorOperation::insert);
  }

  /** Free lines of nodes with couplings of one, which are coupled with each
   * other by @p coupling: each line has an eigenvalue of its order. */
  void
  set_lines(const double coupling)
  {
    for (const auto i : rhs.locally_owned_elements())
      {
        double diagonal = 4 * coupling;
        for (const auto j : neighbors(i))
          if (i != j)
            {
              const bool   in_line = (i + 1 == j || j + 1 == i);
              const double a       = (in_line ? 1 : coupling);
              matrix.set(i, j, -a);
              diagonal += (in_line ? a : 0);
            }
        matrix.set(i, i, diagonal);
      }
    matrix.compress(VectorOperation::insert);
  }

  /** Add the identity times a factor, and a skew-symmetric part. */
  void
  set_with_wind(const double shift, const double wind)
  {
    for (const auto i : rhs.locally_owned_elements())
      for (const auto j : neighbors(i))
        matrix.set(i, j, i == j ? 6 + shift : -1 + (i < j ? wind : -wind));
    matrix.compress(VectorOperation::insert);
  }

  /** The number of negative eigenvalues of its symmetric part. */
  static unsigned int
  n_negative(const double shift)
  {
    unsigned int n    = 0;
    const auto   part = [](const unsigned int k) {
      return 2 - 2 * std::cos(k * numbers::PI / (side + 1));
    };
    for (unsigned int i = 1; i <= side; ++i)
      for (unsigned int j = 1; j <= side; ++j)
        for (unsigned int k = 1; k <= side; ++k)
          n += (part(i) + part(j) + part(k) + shift < 0);
    return n;
  }

  /** Relative to the matrix and the solution. */
  double
  relative_residual() const
  {
    LA::Vector residual(rhs);
    return matrix.residual(residual, solution, rhs) /
           (matrix.linfty_norm() * solution.l2_norm());
  }

private:
  static std::vector<types::global_dof_index>
  neighbors(const types::global_dof_index i)
  {
    std::vector<types::global_dof_index> found  = {i};
    unsigned int                         stride = 1;
    for (unsigned int d = 0; d < 3; ++d, stride *= side)
      {
        const unsigned int place = i / stride % side;
        if (place > 0)
          found.push_back(i - stride);
        if (place + 1 < side)
          found.push_back(i + stride);
      }
    return found;
  }

  static constexpr unsigned int side = 18;

  const MPI_Comm comm = MPI_COMM_WORLD;
};

#endif
