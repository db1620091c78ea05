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
   * The unknowns of a node are the mean and half the difference of the
   * displacements of the faces, see MixedElement::Part; the smoother alone
   * handles the stiff difference. The six rigid motions, in the frames of the
   * nodes, are the near null space.
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
    factorize(const LA::SparseMatrix &A,
              const bool              symmetric,
              const bool              similar = false) override;

    LinearSolverResult
    solve(LA::Vector &x, const LA::Vector &b, const double tolerance) override;

  private:
    const Parameters     parameters;
    dealii::TimerOutput &timer;

    const LA::SparseMatrix                   *matrix = nullptr;
    dealii::TrilinosWrappers::PreconditionAMG preconditioner;
    /** The rigid motions, one after the other. */
    std::vector<double> near_null_space;
  };
} // namespace Biface

#endif
