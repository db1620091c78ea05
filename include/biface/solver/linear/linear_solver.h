// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_linear_solver_h
#define biface_solver_linear_linear_solver_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <optional>
#include <string>

#include <biface/base/linear_algebra.h>
#include <biface/model/shell_mesh.h>
#include <biface/solver/failure.h>

namespace Biface
{
  /** How a linear solve ended. */
  struct LinearSolverResult
  {
    bool success = false;
    /** Where it failed: a sentence that says why. */
    std::string  message;
    FailureCause cause = FailureCause::singular_tangent;
    /** Of a symmetric matrix, where the solver counts them. */
    std::optional<unsigned int> n_negative_pivots;
  };


  /**
   * Solves a sequence of linear systems whose matrices share one pattern.
   */
  class LinearSolver
  {
  public:
    struct Parameters
    {
      enum class Type
      {
        direct,
        amesos,
        iterative
      };

      Type type = Type::direct;

      /** See MultigridSolver. */
      struct Multigrid
      {
        unsigned int max_iterations = 1000;
        unsigned int restart_length = 500;
        unsigned int sweeps         = 2;

        void
        add_parameters(dealii::ParameterHandler &prm);
      };

      Multigrid multigrid;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    virtual ~LinearSolver() = default;

    /**
     * Prepare to solve systems with the matrix @p A, which must stay as it is
     * until the last of them is solved. A failure (a singular matrix, say) is
     * an ordinary result, the same on all ranks.
     *
     * @param symmetric whether the matrix is symmetric, so that half of it
     * will do.
     */
    virtual LinearSolverResult
    factorize(const LA::SparseMatrix &A, const bool symmetric) = 0;

    /**
     * Solve @f$A x = b@f$ with the matrix last given to factorize().
     *
     * @param tolerance the fraction to which an iteration reduces its own norm
     * of the residual; a direct solver goes as far as it can.
     */
    virtual LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) = 0;
  };


  /** The linear solver that the parameters describe. The objects are kept by
   * reference.
   * @param timer gets the sections "Linear solver: ...". */
  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolver::Parameters &parameters,
                     const ShellMesh                &mesh,
                     dealii::TimerOutput            &timer);


  /**
   * Compute the residual of a solution and judge it: a direct solver gives
   * numbers for a singular matrix, too.
   *
   * @return success where the solution is finite, its residual is at most 1e-3
   * of the right hand side and at most 1e-10 of @f$|A|_\infty|x| + |b|@f$.
   */
  LinearSolverResult
  check_solution(const LA::SparseMatrix &A,
                 const LA::Vector       &x,
                 const LA::Vector       &b);
} // namespace Biface

#endif
