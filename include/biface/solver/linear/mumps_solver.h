// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_mumps_solver_h
#define biface_solver_linear_mumps_solver_h

#include <deal.II/base/timer.h>

#include <mpi.h>

#include <memory>
#include <vector>

#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /**
   * The multifrontal direct solver MUMPS @cite AmestoyDuffLExcellentKoster2001,
   * called directly: @f$LDL^T@f$ for symmetric matrices, @f$LU@f$ otherwise.
   * Each rank passes its own rows; the sparsity pattern is analyzed once.
   *
   * Factors in single precision take half the memory and little more than half
   * the time. They are used as a preconditioner of GMRES in double precision.
   * If it does not converge in a few iterations, as in very thin shells,
   * factors are computed in double precision from then on. In small problems,
   * where the time of a factorization is not what matters, they always are.
   *
   * Where there is GMRES anyway, a nearly symmetric matrix is preconditioned by
   * the factors of its symmetric part, which take half the time and tell its
   * negative pivots. If it does not converge in a few iterations, the whole
   * matrix is factorized from then on.
   *
   * The factors of a similar matrix are kept as a preconditioner, too. If GMRES
   * does not converge in a few iterations, which together take less time than a
   * factorization, the matrix is factorized after all.
   */
  class MumpsSolver : public LinearSolver
  {
  public:
    /** @param timer receives the sections "Linear solver: ...".
     * @param single_precision whether factors in single precision are tried. */
    MumpsSolver(const MPI_Comm       communicator,
                dealii::TimerOutput &timer,
                const bool           single_precision = true);

    ~MumpsSolver() override;

    LinearSolverResult
    factorize(const LA::SparseMatrix &A, const Symmetry symmetry) override;

    LinearSolverResult
    keep_factors(const LA::SparseMatrix &A,
                 const Symmetry          symmetry,
                 const Correction       &correction = {}) override;

    bool
    can_keep_factors() const override;

    bool
    has_kept_factors() const override
    {
      return factors_of == FactorsOf::similar_matrix;
    }

    bool
    solve_by_factors(std::vector<LA::Vector>       &x,
                     const std::vector<LA::Vector> &b) override;

    /** Factorize a matrix in double precision, see
     * LinearSolver::factorize_for_many(). */
    LinearSolverResult
    factorize_for_many(const LA::SparseMatrix &A,
                       const bool              symmetric) override;

    std::optional<unsigned int>
    count_negative_pivots(const LA::SparseMatrix &A, const bool often) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

    LinearSolverResult
    solve_all(std::vector<LA::Vector>       &x,
              const std::vector<LA::Vector> &b,
              const double                   tolerance) override;

    /** Solve @f$A^T x = b@f$ by factors of the matrix in double precision. */
    LinearSolverResult
    solve_transposed(LA::Vector       &x,
                     const LA::Vector &b,
                     const double      tolerance) override;

  private:
    /** The part of a matrix that is factorized. */
    enum class Part
    {
      whole,
      /** One half of a symmetric matrix. */
      half,
      symmetric_part
    };

    class Factors;
    template <typename number>
    class FactorsIn;

    /** The matrix to which the factors belong. */
    enum class FactorsOf
    {
      /** There are no factors; the pattern may have been analyzed. */
      nothing,
      similar_matrix,
      matrix
    };

    /** The part of the matrix that new factors are of. */
    Part
    wanted_part() const;

    /** Whether the factors have the pattern of the matrix and the precision of
     * new ones. */
    bool
    factors_fit() const;

    LinearSolverResult
    factorize_anew();

    LinearSolverResult
    factorize_in_double_precision();

    /** Analyze the sparsity pattern and choose the precision.
     * @return INFOG(1) of MUMPS, negative if it failed. */
    int
    analyze();

    /** The result of a factorization: success, and the pivots of the factors.
     */
    LinearSolverResult
    factorized() const;

    /** Solve by GMRES, with the factors, which may be those of another matrix,
     * as a preconditioner.
     * @param tolerance of the residual, relative to @p b.
     * @return whether GMRES converged. */
    bool
    solve_with_gmres(LA::Vector       &x,
                     const LA::Vector &b,
                     const double      tolerance);

    const MPI_Comm       communicator;
    dealii::TimerOutput &timer;
    /** Whether new factors are in single precision where that saves time. */
    bool single_precision;
    /** Whether the symmetric part of nearly symmetric matrices has been
     * sufficient. */
    bool                     symmetric_part_suffices = true;
    const LA::SparseMatrix  *matrix                  = nullptr;
    Symmetry                 symmetry                = Symmetry::none;
    std::unique_ptr<Factors> factors;
    /** The factors that count_negative_pivots() keeps from one call to the
     * next. */
    std::unique_ptr<Factors> counting_factors;
    FactorsOf                factors_of = FactorsOf::nothing;
    /** What corrects the solutions with the factors of a similar matrix; may be
     * empty. */
    Correction correction;
  };
} // namespace Biface

#endif
