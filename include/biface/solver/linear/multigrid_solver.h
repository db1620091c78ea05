// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_multigrid_solver_h
#define biface_solver_linear_multigrid_solver_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <array>
#include <deque>
#include <memory>
#include <utility>

#include <biface/model/mesh/coarse_spaces.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/solver/linear/line_gauss_seidel.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /**
   * GMRES with multigrid: V-cycles on the mesh and on those of every second
   * line, with Galerkin's matrices @f$P^TAP@f$ and a direct solver on the
   * coarsest one. GMRES is also used for symmetric matrices: on fine meshes,
   * the tangent of a shell in contact has negative eigenvalues, and conjugate
   * gradients fail. The smoother solves along grid lines, since cells far from
   * the contact may be much longer than wide.
   *
   * The tolerance refers to the preconditioned residual, which is close to the
   * error. In the residual itself, the stiffness of the contact and of the
   * thickness dominate.
   *
   * Functions of the coarser meshes do not move nodes against the ground
   * that holds them, like the truncated functions of monotone multigrid
   * @cite Kornhuber1994. Such nodes are found by the forces that a rigid
   * translation of the shell exerts on them.
   *
   * Failure to converge is an ordinary result.
   */
  class MultigridSolver : public LinearSolver
  {
  public:
    using Parameters = LinearSolver::Parameters::Multigrid;

    /** @param timer receives the sections "Linear solver: ...". */
    MultigridSolver(const Parameters    &parameters,
                    const ShellMesh     &mesh,
                    dealii::TimerOutput &timer);

    LinearSolverResult
    factorize(const LA::SparseMatrix &A, const Symmetry symmetry) override;

    /** Keep the matrices of the coarser meshes as long as a few iterations are
     * sufficient with them. */
    LinearSolverResult
    keep_factors(const LA::SparseMatrix &A,
                 const Symmetry          symmetry,
                 const Correction       &correction = {}) override;

    /** The number of negative pivots, only where there are no coarser
     * meshes. */
    std::optional<unsigned int>
    count_negative_pivots(const LA::SparseMatrix &A, const bool often) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

    /** Solve @f$A^T x = b@f$ with the preconditioner of the matrix itself: that
     * of a shell is nearly symmetric. */
    LinearSolverResult
    solve_transposed(LA::Vector       &x,
                     const LA::Vector &b,
                     const double      tolerance) override;

    /** The preconditioner: one V-cycle. */
    void
    vmult(LA::Vector &x, const LA::Vector &b) const;

  private:
    /** A level of the multigrid method; the coarsest one is none. */
    struct Level
    {
      Level(LA::SparseMatrix &&interpolation)
        : interpolation(std::move(interpolation))
      {}

      GridLineNodes   nodes;
      LineGaussSeidel smoother;
      /** The interpolation from the next coarser level. */
      LA::SparseMatrix interpolation;
      /** The part of the interpolation that does not move nodes against the
       * ground; null if that is all of it. */
      std::unique_ptr<LA::SparseMatrix> truncated;
      std::unique_ptr<LA::SparseMatrix> coarse_matrix;
      /** Vectors in which cycle() works. */
      mutable LA::Vector residual, correction;
      mutable LA::Vector coarse_residual, coarse_correction;

      const LA::SparseMatrix &
      prolongation() const
      {
        return truncated ? *truncated : interpolation;
      }
    };

    /** Compute all matrices anew. */
    LinearSolverResult
    set_up();

    /** Compute the factors of the smoother of a level. */
    bool
    initialize_smoother(Level &level, const LA::SparseMatrix &A);

    LinearSolverResult
    solve(const LinearSystem system,
          LA::Vector        &x,
          const LA::Vector  &b,
          const double       tolerance);

    LinearSolverResult
    iterate(const LinearSystem system,
            LA::Vector        &x,
            const LA::Vector  &b,
            const double       tolerance,
            const unsigned int max_iterations);

    /** Solve approximately on a level. */
    void
    cycle(const unsigned int level, LA::Vector &x, const LA::Vector &b) const;

    /** Find Level::truncated for the finest level.
     * @return whether no node held by the ground has a singular matrix, on
     * all ranks. */
    bool
    truncate_prolongation();

    const Parameters     parameters;
    dealii::TimerOutput &timer;

    /** The timer of the coarsest level, which is part of the set-up unless it
     * is the only level. */
    dealii::ConditionalOStream    no_output;
    dealii::TimerOutput           coarse_timer;
    std::unique_ptr<LinearSolver> coarsest;

    /** The levels from the finest one on. */
    std::deque<Level> levels;
    bool              coarse_matrices_exist = false;
    /** Whether the coarse matrices are those of a similar matrix. */
    bool coarse_matrices_are_kept = false;
    /** The rigid translations of the mesh. */
    std::array<LA::Vector, 3> translations;
    const LA::SparseMatrix   *matrix   = nullptr;
    Symmetry                  symmetry = Symmetry::none;
  };
} // namespace Biface

#endif
