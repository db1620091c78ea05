// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <sstream>

#include <biface/input/parameter_tools.h>
#include <biface/solver/linear/amesos_solver.h>
#include <biface/solver/linear/linear_solver.h>
#include <biface/solver/linear/multigrid_solver.h>
#ifdef BIFACE_WITH_MUMPS
#  include <biface/solver/linear/mumps_solver.h>
#endif

namespace Biface
{
  using namespace dealii;

  void
  LinearSolver::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Type",
      type,
      {"direct", "Amesos", "iterative"},
      "'direct' (MUMPS: LDL^T if the tangent is symmetric, LU otherwise), "
      "'Amesos' (the direct solvers UMFPACK or KLU on the first rank: "
      "slower; also used for 'direct' if the program was built without "
      "MUMPS) or 'iterative' (GMRES with algebraic multigrid: less memory, "
      "more time).");
    multigrid.add_parameters(prm);
  }


  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolver::Parameters &parameters,
                     const ShellMesh                &mesh,
                     TimerOutput                    &timer)
  {
    switch (parameters.type)
      {
        case LinearSolver::Parameters::Type::direct:
#ifdef BIFACE_WITH_MUMPS
          return std::make_unique<MumpsSolver>(mesh.communicator, timer);
#endif
        case LinearSolver::Parameters::Type::amesos:
          return std::make_unique<AmesosSolver>(timer);
        case LinearSolver::Parameters::Type::iterative:
          return std::make_unique<MultigridSolver>(
            parameters.multigrid, mesh, timer);
      }
    Assert(false, ExcInternalError());
    return {};
  }


  LinearSolverResult
  check_solution(const LA::SparseMatrix &A,
                 const LA::Vector       &x,
                 const LA::Vector       &b)
  {
    LA::Vector   residual(b);
    const double norm_r = A.residual(residual, x, b);
    const double norm_b = b.l2_norm();
    const double norm_x = x.l2_norm();

    // Round-off causes a residual of order eps |A| |x|, which for a thin shell
    // is much larger than eps |b|. For a singular matrix it is of order |b|.
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
