// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_multigrid_solver_h
#define biface_solver_linear_multigrid_solver_h

#include <deal.II/base/timer.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <memory>
#include <vector>

#include <biface/model/shell_mesh.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /**
   * Krylov's method with algebraic multigrid by smoothed aggregation (Trilinos
   * ML). The method is GMRES for symmetric matrices, too: on fine meshes, the
   * tangent of a shell pressed flat has negative eigenvalues, and conjugate
   * gradients fail.
   *
   * The preconditioned residual is what is reduced. It is close to the error:
   * in the residual itself, stiff contact and stiff thickness outweigh all
   * else.
   *
   * Two things make multigrid work for a shell with two faces. The unknowns are
   * changed to the mean and half the difference of both faces, of which the
   * stiff difference is dealt with by the smoother alone. And the six rigid
   * motions, in the frames of the nodes, are given as the near null space.
   *
   * It needs less memory than a factorization, and more time on meshes that fit
   * into one. Where it does not converge, that is its result.
   */
  class MultigridSolver : public LinearSolver
  {
  public:
    using Parameters = LinearSolver::Parameters::Multigrid;

    /** @param timer gets the sections "Linear solver: ...". */
    MultigridSolver(const Parameters    &parameters,
                    const ShellMesh     &mesh,
                    dealii::TimerOutput &timer);

    LinearSolverResult
    factorize(const LA::SparseMatrix &A, const bool symmetric) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

  private:
    /** Change the matrix, of which this is a copy, to the unknowns of mean and
     * difference. */
    void
    transform_matrix();

    /** @f$T^T b@f$ and @f$T x@f$ for @f$v^\pm = m \pm d@f$. */
    void
    to_means_and_differences(LA::Vector &forces) const;
    void
    to_faces(LA::Vector &displacements) const;

    const Parameters     parameters;
    const ShellMesh     &mesh;
    dealii::TimerOutput &timer;

    LA::SparseMatrix                          matrix;
    dealii::TrilinosWrappers::PreconditionAMG preconditioner;
    /** The rigid motions in the changed unknowns, one after the other. */
    std::vector<double> near_null_space;
    /** Inner-face degrees of freedom, as local indices, whose pair is free: the
     * outer face's is the next one. */
    std::vector<unsigned int> pairs;
  };
} // namespace Biface

#endif
