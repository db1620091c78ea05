// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_linear_solver_parameters_h
#define biface_solver_linear_linear_solver_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <memory>

#include <biface/model/shell_mesh.h>
#include <biface/solver/linear/linear_solver.h>
#include <biface/solver/linear/multigrid_solver.h>

namespace Biface
{
  /** Which linear solver is used. */
  struct LinearSolverParameters
  {
    enum class Type
    {
      direct,
      amesos,
      iterative
    };

    Type                        type = Type::direct;
    MultigridSolver::Parameters multigrid;

    void
    add_parameters(dealii::ParameterHandler &prm);
  };


  /** The linear solver that the parameters describe. The objects are kept by
   * reference. */
  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolverParameters &parameters,
                     const ShellMesh              &mesh,
                     dealii::TimerOutput          &timer);
} // namespace Biface

#endif
