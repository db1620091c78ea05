// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>
#include <sstream>

#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  using namespace dealii;

  void
  LinearSolver::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_choice(
      prm,
      "Type",
      type,
      {"direct", "iterative"},
      "'direct' (MUMPS: LDL^T if the tangent is symmetric, LU otherwise) or "
      "'iterative' (GMRES with multigrid, which halves the number of grid "
      "lines again and again: less memory, and on fine meshes less time).");
    multigrid.add_parameters(prm);
  }


  LinearSolverResult
  LinearSolver::solve_all(std::vector<LA::Vector>       &x,
                          const std::vector<LA::Vector> &b,
                          const double                   tolerance)
  {
    AssertDimension(x.size(), b.size());
    LinearSolverResult result;
    result.success = true;
    for (unsigned int i = 0; i < b.size() && result.success; ++i)
      result = solve(x[i], b[i], tolerance);
    return result;
  }


  void
  SystemMatrix::vmult(LA::Vector &product, const LA::Vector &x) const
  {
    if (system == LinearSystem::original)
      A.vmult(product, x);
    else
      A.Tvmult(product, x);
  }


  double
  SystemMatrix::residual(LA::Vector       &result,
                         const LA::Vector &x,
                         const LA::Vector &b) const
  {
    vmult(result, x);
    result.sadd(-1, 1, b);
    return result.l2_norm();
  }


  LinearSolverResult
  solve_with_refinement(
    const SystemMatrix &matrix,
    LA::Vector         &x,
    const LA::Vector   &b,
    const std::function<LinearSolverResult(LA::Vector &, const LA::Vector &)>
      &solve)
  {
    constexpr double       tolerance     = 1e-10;
    constexpr double       contraction   = 0.05;
    constexpr unsigned int n_refinements = 3;

    LinearSolverResult result = solve(x, b);
    if (!result.success)
      return result;

    const double norm_b = b.l2_norm();
    LA::Vector   residual(b), correction(b);
    // what remains of the solution's error, by its last correction
    double error = std::numeric_limits<double>::infinity();
    double relative;
    for (unsigned int k = 0;; ++k)
      {
        const double norm = matrix.residual(residual, x, b);
        relative          = (norm_b > 0 ? norm / norm_b : norm);
        if (relative <= tolerance || error <= tolerance)
          {
            result.error = 0;
            return result;
          }
        if (k == n_refinements || !std::isfinite(relative))
          break;
        result = solve(correction, residual);
        if (!result.success)
          return result;
        const double last = error;
        error             = correction.linfty_norm() / x.linfty_norm();
        // corrections that do not shrink improve nothing any more: they are
        // round-off, or the matrix is singular
        if (!(error < last / 2))
          break;
        x += correction;
      }

    result.error   = error;
    result.success = (error <= contraction);
    if (!result.success)
      {
        std::ostringstream message;
        message << "the linear system was not solved (relative residual "
                << relative << ", norm of the solution " << x.l2_norm()
                << "): the tangent is singular or nearly so";
        result.message = message.str();
      }
    return result;
  }
} // namespace Biface
