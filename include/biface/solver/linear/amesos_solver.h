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
   * A serial direct solver through the package Amesos of Trilinos, for where
   * MUMPS itself is missing: UMFPACK, or else KLU, which Trilinos always has.
   * Both take every matrix for unsymmetric and work on the first rank; the
   * analysis of the pattern is done once.
   */
  class AmesosSolver : public LinearSolver
  {
  public:
    /** @param timer gets the sections "Linear solver: ...". */
    explicit AmesosSolver(dealii::TimerOutput &timer);

    ~AmesosSolver() override;

    LinearSolverResult
    factorize(const LA::SparseMatrix &A, const bool symmetric) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

  private:
    dealii::TimerOutput                  &timer;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    solver;
    /** The matrix last factorized. */
    const LA::SparseMatrix *matrix = nullptr;
  };
} // namespace Biface

#endif
