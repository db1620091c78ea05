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
   * called without an intermediary: @f$LDL^T@f$ where the matrix is symmetric,
   * @f$LU@f$ where not; each rank hands over its own rows; the analysis of the
   * pattern is done once.
   */
  class MumpsSolver : public LinearSolver
  {
  public:
    /** @param timer gets the sections "Linear solver: ...". */
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
    /** The matrix last factorized. */
    const LA::SparseMatrix *matrix = nullptr;
  };
} // namespace Biface

#endif
