// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_nonlocal_correction_h
#define biface_solver_nonlocal_correction_h

#include <functional>
#include <memory>
#include <optional>

#include <biface/model/equations/equation_system.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /**
   * Turns solutions of systems with a tangent @f$\mathbf K@f$ into those with
   * the whole derivative @f$\mathbf K+\mathbf N@f$, where @f$\mathbf N@f$ is
   * EquationSystem::nonlocal_part(): GMRES with @f$\mathbf K@f$ as
   * preconditioner from the right, whose residuals are forces. Mostly there is
   * no such part, and nothing is done.
   */
  class NonlocalCorrection
  {
  public:
    /** A function that solves a system with the tangent. */
    using Solve =
      std::function<LinearSolverResult(LA::Vector &x, const LA::Vector &b)>;

    /** Prepare for the state of the last assembly.
     * @param equations kept by reference.
     * @param tolerance the residual relative to the right hand side. */
    NonlocalCorrection(const EquationSystem &equations,
                       const State          &state,
                       const Solve          &solve,
                       const double          tolerance);

    /** Correct the solution of a system.
     * @param x the solution with @f$\mathbf K@f$, with the displacements that
     * supports prescribe.
     * @param b the right hand side.
     * @return the failure, if any. Must be called on all ranks. */
    std::optional<LinearSolverResult>
    correct(LA::Vector &x, const LA::Vector &b) const;

  private:
    const EquationSystem                    &equations;
    std::unique_ptr<const NonlocalStiffness> nonlocal;
    const Solve                              solve;
    const double                             tolerance;
  };
} // namespace Biface

#endif
