// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_complex_solver_h
#define biface_solver_linear_complex_solver_h

#include <mpi.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * Solves complex systems whose matrices have the same sparsity pattern, by
   * MUMPS. The rows of the ranks are contiguous, in the order of the ranks. All
   * functions must be called on all ranks and return the same there.
   */
  class ComplexSolver
  {
  public:
    using Number = std::complex<double>;
    /** The entries of this rank's rows. */
    using Vector = std::vector<Number>;

    /** A place in the matrix, from 0. */
    struct Place
    {
      unsigned int row, column;
    };

    /**
     * @param n_rows the number of rows of this rank.
     * @param places of the entries of this rank, in any rows; entries in the
     * same place add up.
     * @param symmetric whether the matrix is symmetric (not Hermitian), of
     * which the entries on and below the diagonal are given.
     */
    ComplexSolver(const MPI_Comm            communicator,
                  const unsigned int        n_rows,
                  const std::vector<Place> &places,
                  const bool                symmetric);

    ~ComplexSolver();

    ComplexSolver(const ComplexSolver &) = delete;

    /** Factorize the matrix with the given entries.
     * @return why this failed, or an empty string. */
    std::string
    factorize(std::vector<Number> &entries);

    /** Replace right-hand sides by the solutions.
     * @return whether this succeeded. */
    bool
    solve(std::vector<Vector> &x);

  private:
    struct Mumps;

    const MPI_Comm         communicator;
    std::unique_ptr<Mumps> mumps;
    bool                   is_analyzed = false;
  };
} // namespace Biface

#endif
