// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/input/parameter_tools.h>
#include <biface/solver/linear/amesos_solver.h>
#include <biface/solver/linear/linear_solver_parameters.h>
#ifdef BIFACE_WITH_MUMPS
#  include <biface/solver/linear/mumps_solver.h>
#endif

namespace Biface
{
  using namespace dealii;

  void
  LinearSolverParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Type",
      type,
      {"direct", "Amesos", "iterative"},
      "'direct' (MUMPS: LDL^T where the tangent is symmetric, LU where not), "
      "'Amesos' (the direct solver UMFPACK or KLU on the first rank: slower; "
      "also what 'direct' means where the program was built without MUMPS) or "
      "'iterative' (GMRES with algebraic multigrid: "
      "less memory, more time).");
    multigrid.add_parameters(prm);
  }


  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolverParameters &parameters,
                     const ShellMesh              &mesh,
                     TimerOutput                  &timer)
  {
    switch (parameters.type)
      {
        case LinearSolverParameters::Type::direct:
#ifdef BIFACE_WITH_MUMPS
          return std::make_unique<MumpsSolver>(mesh.communicator, timer);
#endif
        case LinearSolverParameters::Type::amesos:
          return std::make_unique<AmesosSolver>(timer);
        case LinearSolverParameters::Type::iterative:
          return std::make_unique<MultigridSolver>(
            parameters.multigrid, mesh, timer);
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
