// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_amesos_solver_h
#define biface_solver_linear_amesos_solver_h

#include <deal.II/base/timer.h>

#include <memory>

#include <biface/solver/linear/linear_solver.h>

class Amesos_BaseSolver;
class Epetra_LinearProblem;

namespace Biface
{
  /**
   * A serial direct solver through the Trilinos package Amesos, used if MUMPS
   * is not available: UMFPACK, or otherwise KLU, which is always part of
   * Trilinos. Both treat every matrix as unsymmetric and run on the first rank;
   * the sparsity pattern is analyzed once.
   */
  class AmesosSolver : public LinearSolver
  {
  public:
    /** @param timer receives the sections "Linear solver: ...". */
    explicit AmesosSolver(dealii::TimerOutput &timer);

    ~AmesosSolver() override;

    LinearSolverResult
    factorize(const LA::SparseMatrix &A,
              const bool              symmetric,
              const bool              similar = false) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

    LinearSolverResult
    solve_transposed(LA::Vector       &x,
                     const LA::Vector &b,
                     const double      tolerance) override;

  private:
    LinearSolverResult
    solve(const System system, LA::Vector &x, const LA::Vector &b);

    dealii::TimerOutput                  &timer;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    solver;
    /** The last factorized matrix. */
    const LA::SparseMatrix *matrix = nullptr;
  };
} // namespace Biface

#endif
