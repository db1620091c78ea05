// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_linear_solver_h
#define biface_solver_linear_linear_solver_h

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/solver/failure.h>

namespace Biface
{
  class EntryDeclarations;


  /** The result of a linear solve. */
  struct LinearSolverResult
  {
    bool success = false;
    /** The reason of a failure, as part of a sentence. */
    std::string  message;
    FailureCause cause = FailureCause::singular_tangent;
    /** An estimate of the error of a solution relative to its maximum; zero if
     * the residual leaves no doubt. */
    double error = 0;
    /** The number of negative pivots of the last matrix that was factorized, or
     * of its symmetric part, if that was, if the solver counts them. */
    std::optional<unsigned int> n_negative_pivots;
    /** Whether the pivots are those of the given matrix, in double precision,
     * and not of a similar or a rounded one. */
    bool pivots_are_exact = false;
  };


  /** What is known of the symmetry of a matrix. */
  enum class Symmetry
  {
    none,
    /** The matrix is close to its symmetric part. */
    nearly,
    full
  };


  /** Which of two systems is solved with the same factors. */
  enum class LinearSystem
  {
    /** The system @f$A x = b@f$. */
    original,
    /** The system @f$A^T x = b@f$. */
    transposed
  };


  /**
   * Solves a sequence of linear systems whose matrices have the same sparsity
   * pattern.
   */
  class LinearSolver
  {
  public:
    struct Parameters
    {
      enum class Type
      {
        direct,
        iterative
      };

      Type type = Type::direct;

      bool
      is_iterative() const
      {
        return type == Type::iterative;
      }

      /** Parameters of MultigridSolver. */
      struct Multigrid
      {
        unsigned int max_iterations    = 300;
        unsigned int coarsest_unknowns = 12000;

        void
        add_parameters(EntryDeclarations &prm);
      };

      Multigrid multigrid;

      void
      add_parameters(EntryDeclarations &prm);
    };

    virtual ~LinearSolver() = default;

    /**
     * Prepare to solve systems with the matrix @p A, which must not change
     * until the last of them is solved. A failure, such as a singular matrix,
     * is an ordinary result, the same on all ranks.
     *
     * Half of a symmetric matrix is sufficient; the symmetric part of one that
     * is nearly symmetric is a preconditioner.
     */
    virtual LinearSolverResult
    factorize(const LA::SparseMatrix &A, const Symmetry symmetry) = 0;

    /** Turns a solution with the factors of one matrix into nearly one of
     * another. */
    using Correction = std::function<void(LA::Vector &x)>;

    /** Prepare to solve systems with the matrix @p A, with the factors of
     * another matrix, which is similar or made so by a correction, as a
     * preconditioner if the solver has any. */
    virtual LinearSolverResult
    keep_factors(const LA::SparseMatrix &A,
                 const Symmetry          symmetry,
                 const Correction & /*correction*/ = {})
    {
      return factorize(A, symmetry);
    }

    /** Whether the solver has factors that it can keep. */
    virtual bool
    can_keep_factors() const
    {
      return false;
    }

    /** Whether the factors are those of another matrix than the present one. */
    virtual bool
    has_kept_factors() const
    {
      return false;
    }

    /** Solve systems by the present factors alone, of whatever matrix, up to
     * their round-off.
     * @return whether the solver does so. */
    virtual bool
    solve_by_factors(std::vector<LA::Vector> & /*x*/,
                     const std::vector<LA::Vector> & /*b*/)
    {
      return false;
    }

    /** Prepare for so many systems with one matrix that each of them should be
     * solved as fast and as exactly as possible. */
    virtual LinearSolverResult
    factorize_for_many(const LA::SparseMatrix &A, const bool symmetric)
    {
      return factorize(A, symmetric ? Symmetry::full : Symmetry::none);
    }

    /** The number of negative pivots of the symmetric part of a matrix in
     * double precision, if the solver counts them: that of its negative
     * eigenvalues.
     *
     * If this is done often, for matrices with one pattern in every step,
     * factors of all stay. Otherwise large factors are released, also those of
     * other matrices, so that there is memory for one set of them only. */
    virtual std::optional<unsigned int>
    count_negative_pivots(const LA::SparseMatrix & /*A*/, const bool /*often*/)
    {
      return {};
    }

    /**
     * Solve @f$A x = b@f$ with the last matrix passed to factorize().
     *
     * @param tolerance the relative reduction of the residual by iterations, in
     * the norm of the solver. Without any, a solution by factors is exact up to
     * round-off.
     */
    virtual LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) = 0;

    /** Solve @f$A x_i = b_i@f$ for several right hand sides, which a direct
     * solver handles faster at once.
     * @return that of the first system that was not solved, if any. */
    virtual LinearSolverResult
    solve_all(std::vector<LA::Vector>       &x,
              const std::vector<LA::Vector> &b,
              const double                   tolerance);

    /** Solve @f$A^T x = b@f$ with the last matrix passed to factorize(), see
     * solve(). */
    virtual LinearSolverResult
    solve_transposed(LA::Vector       &x,
                     const LA::Vector &b,
                     const double      tolerance) = 0;

    /** Solve @f$A x = b@f$ or @f$A^T x = b@f$. */
    LinearSolverResult
    solve_system(const LinearSystem system,
                 LA::Vector        &x,
                 const LA::Vector  &b,
                 const double       tolerance)
    {
      return system == LinearSystem::original
               ? solve(x, b, tolerance)
               : solve_transposed(x, b, tolerance);
    }
  };


  /** The matrix of a system or its transpose, kept by reference. */
  struct SystemMatrix
  {
    const LA::SparseMatrix &A;
    const LinearSystem      system;

    void
    vmult(LA::Vector &product, const LA::Vector &x) const;

    /** Compute @p b minus the product with @p x.
     * @return its norm. */
    double
    residual(LA::Vector       &result,
             const LA::Vector &x,
             const LA::Vector &b) const;
  };


  /**
   * Solve a system by a direct solver and improve the solution by
   * iterative refinement if its residual exceeds 1e-10 of the right hand side,
   * as it does if a shell is very thin.
   *
   * A direct solver may return numbers even for a singular matrix. The
   * refinement tells: its corrections are as large as the solution.
   *
   * @param solve computes a solution for a given right hand side.
   */
  LinearSolverResult
  solve_with_refinement(
    const SystemMatrix &matrix,
    LA::Vector         &x,
    const LA::Vector   &b,
    const std::function<LinearSolverResult(LA::Vector &, const LA::Vector &)>
      &solve);
} // namespace Biface

#endif
