// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_mumps_solver_h
#define biface_solver_linear_mumps_solver_h

#include <deal.II/base/timer.h>

#include <mpi.h>

#include <memory>

#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /**
   * The multifrontal direct solver MUMPS @cite AmestoyDuffLExcellentKoster2001,
   * called directly: @f$LDL^T@f$ for symmetric matrices, @f$LU@f$ otherwise.
   * Each rank passes its own rows; the sparsity pattern is analyzed once.
   *
   * The factors of a similar matrix are kept as a preconditioner of GMRES. If
   * it does not converge in a few iterations, which together take less time
   * than a factorization, the matrix is factorized after all.
   */
  class MumpsSolver : public LinearSolver
  {
  public:
    /** @param timer receives the sections "Linear solver: ...". */
    MumpsSolver(const MPI_Comm communicator, dealii::TimerOutput &timer);

    ~MumpsSolver() override;

    LinearSolverResult
    factorize(const LA::SparseMatrix &A,
              const bool              symmetric,
              const bool              similar = false) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

  private:
    class Instance;

    LinearSolverResult
    factorize_anew();

    /** The result of a factorization: success, and the pivots of the factors.
     */
    LinearSolverResult
    factorized() const;

    /** Solve with the factors of another matrix.
     * @return whether GMRES converged. */
    bool
    solve_with_old_factors(LA::Vector &x, const LA::Vector &b);

    const MPI_Comm            communicator;
    dealii::TimerOutput      &timer;
    std::unique_ptr<Instance> instance;
    const LA::SparseMatrix   *matrix              = nullptr;
    bool                      matrix_is_symmetric = false;
    /** Whether the factors are those of the matrix. */
    bool factors_are_current = false;
  };
} // namespace Biface

#endif
