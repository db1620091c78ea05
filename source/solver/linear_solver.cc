// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <sstream>

#include <biface/solver/linear_solver.h>

namespace Biface
{
  LinearSolverResult
  check_solution(const LA::SparseMatrix &A,
                 const LA::Vector       &x,
                 const LA::Vector       &b)
  {
    LA::Vector   residual(b);
    const double norm_b = b.l2_norm();
    const double norm_r = A.residual(residual, x, b);
    const double norm_x = x.l2_norm();

    LinearSolverResult result;
    result.relative_residual = (norm_b > 0 ? norm_r / norm_b : norm_r);
    result.success = std::isfinite(norm_x) && result.relative_residual <= 1e-8;
    if (!result.success)
      {
        std::ostringstream message;
        message << "the linear system was not solved (relative residual "
                << result.relative_residual << ", norm of the solution "
                << norm_x << "): the tangent is singular or nearly so";
        result.message = message.str();
      }
    return result;
  }
} // namespace Biface
