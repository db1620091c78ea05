// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/solver/linear/make_linear_solver.h>
#include <biface/solver/linear/multigrid_solver.h>
#include <biface/solver/linear/mumps_solver.h>

namespace Biface
{
  using namespace dealii;

  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolver::Parameters &parameters,
                     const ShellMesh                &mesh,
                     TimerOutput                    &timer)
  {
    switch (parameters.type)
      {
        case LinearSolver::Parameters::Type::direct:
          return std::make_unique<MumpsSolver>(mesh.communicator, timer);
        case LinearSolver::Parameters::Type::iterative:
          return std::make_unique<MultigridSolver>(
            parameters.multigrid, mesh, timer);
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
