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
   */
  class MumpsSolver : public LinearSolver
  {
  public:
    /** @param timer receives the sections "Linear solver: ...". */
    MumpsSolver(const MPI_Comm communicator, dealii::TimerOutput &timer);

    ~MumpsSolver() override;

    LinearSolverResult
    factorize(const LA::SparseMatrix &A, const bool symmetric) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

  private:
    class Instance;

    const MPI_Comm            communicator;
    dealii::TimerOutput      &timer;
    std::unique_ptr<Instance> instance;
    /** The last factorized matrix. */
    const LA::SparseMatrix *matrix = nullptr;
  };
} // namespace Biface

#endif
