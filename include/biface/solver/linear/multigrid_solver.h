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
   * GMRES with algebraic multigrid by smoothed aggregation (Trilinos ML). GMRES
   * is also used for symmetric matrices: on fine meshes, the tangent of a shell
   * in contact has negative eigenvalues, and conjugate gradients fail.
   *
   * The tolerance refers to the preconditioned residual, which is close to the
   * error. In the residual itself, the stiffness of the contact and of the
   * thickness dominate.
   *
   * Two measures make multigrid work for a shell with two faces. The unknowns
   * are transformed to the mean and half the difference of the two faces; the
   * smoother alone handles the stiff difference. The six rigid motions, in the
   * frames of the nodes, are the near null space.
   *
   * It needs less memory than a factorization, but more time if the
   * factorization fits into memory. Failure to converge is an ordinary result.
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
    factorize(const LA::SparseMatrix &A, const bool symmetric) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

  private:
    /** Transform the copy of the matrix to the unknowns mean and half
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
    /** The rigid motions in the transformed unknowns, one after the other. */
    std::vector<double> near_null_space;
    /** Local indices of the degrees of freedom of the inner face that form a
     * free pair with the next index, that of the outer face. */
    std::vector<unsigned int> pairs;
  };
} // namespace Biface

#endif
