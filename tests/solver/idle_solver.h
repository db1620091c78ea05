// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_solver_idle_solver_h
#define biface_tests_solver_idle_solver_h

#include <biface/solver/linear/linear_solver.h>

/** Takes zero for the solution of any system. */
class IdleSolver : public Biface::LinearSolver
{
public:
  Biface::LinearSolverResult
  factorize(const Biface::LA::SparseMatrix &, const Biface::Symmetry) override
  {
    return done();
  }

  Biface::LinearSolverResult
  solve(Biface::LA::Vector &x,
        const Biface::LA::Vector &,
        const double) override
  {
    x = 0;
    return done();
  }

  Biface::LinearSolverResult
  solve_transposed(Biface::LA::Vector       &x,
                   const Biface::LA::Vector &b,
                   const double              tolerance) override
  {
    return solve(x, b, tolerance);
  }

private:
  static Biface::LinearSolverResult
  done()
  {
    Biface::LinearSolverResult result;
    result.success = true;
    return result;
  }
};

#endif
