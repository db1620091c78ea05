// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <string>

#include <biface/solver/nonlocal_correction.h>

namespace Biface
{
  using namespace dealii;

  NonlocalCorrection::NonlocalCorrection(const EquationSystem &equations,
                                         const State          &state,
                                         const Solve          &solve,
                                         const double          tolerance)
    : equations(equations)
    , nonlocal(equations.nonlocal_part(state))
    , solve(solve)
    , tolerance(tolerance)
  {}


  namespace
  {
    /** @f$\mathbf I+\mathbf N\mathbf K^{-1}@f$ */
    struct Operator
    {
      const std::function<void(LA::Vector &, const LA::Vector &)> vmult;
    };
  } // namespace


  std::optional<LinearSolverResult>
  NonlocalCorrection::correct(LA::Vector &x, const LA::Vector &b) const
  {
    constexpr unsigned int max_iterations = 200;

    if (!nonlocal)
      return {};
    std::optional<LinearSolverResult> failure;
    const auto displacements = [&](const LA::Vector &forces) {
      LA::Vector answer = equations.mesh.owned_vector();
      if (failure)
        return answer;
      const LinearSolverResult result = solve(answer, forces);
      if (!result.success)
        failure = result;
      equations.mesh.constraints.distribute(answer);
      return answer;
    };
    const Operator matrix{[&](LA::Vector &product, const LA::Vector &forces) {
      nonlocal->vmult(product, displacements(forces));
      product += forces;
    }};

    // what K leaves
    LA::Vector residual = equations.mesh.owned_vector();
    nonlocal->vmult(residual, x);
    residual *= -1;
    LA::Vector              y = equations.mesh.owned_vector();
    SolverControl           control(max_iterations, tolerance * b.l2_norm());
    SolverGMRES<LA::Vector> gmres(
      control, SolverGMRES<LA::Vector>::AdditionalData(max_iterations + 2));
    try
      {
        // in forces, preconditioned by the tangent: few iterations, since the
        // rest is small
        gmres.solve(matrix, y, residual, PreconditionIdentity());
      }
    catch (const SolverControl::NoConvergence &)
      {
        if (!failure)
          {
            failure.emplace();
            failure->cause   = FailureCause::nonlocal_iterations;
            failure->message = "the stresses that relax around the axle were "
                               "not solved for in " +
                               std::to_string(max_iterations) + " iterations";
          }
      }
    if (!failure)
      x += displacements(y);
    return failure;
  }
} // namespace Biface
