// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <sstream>

#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  LinearSolverResult
  check_solution(const LA::SparseMatrix &A,
                 const LA::Vector       &x,
                 const LA::Vector       &b)
  {
    LA::Vector   residual(b);
    const double norm_r = A.residual(residual, x, b);
    const double norm_b = b.l2_norm();
    const double norm_x = x.l2_norm();

    // Round-off alone leaves a residual of the size of eps |A| |x|, which for a
    // thin shell is much more than eps |b|. A singular matrix leaves one of the
    // size of b.
    LinearSolverResult result;
    const double       relative = (norm_b > 0 ? norm_r / norm_b : norm_r);
    const double backward_error = norm_r / (A.linfty_norm() * norm_x + norm_b);
    result.success =
      std::isfinite(norm_x) &&
      (norm_r == 0 || (relative <= 1e-3 && backward_error <= 1e-10));
    if (!result.success)
      {
        std::ostringstream message;
        message << "the linear system was not solved (relative residual "
                << relative << ", norm of the solution " << norm_x
                << "): the tangent is singular or nearly so";
        result.message = message.str();
      }
    return result;
  }
} // namespace Biface
