// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_make_linear_solver_h
#define biface_solver_linear_make_linear_solver_h

#include <deal.II/base/timer.h>

#include <memory>

#include <biface/model/mesh/shell_mesh.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /** Create the linear solver given by the parameters. The objects are kept by
   * reference.
   * @param timer receives the sections "Linear solver: ...". */
  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolver::Parameters &parameters,
                     const ShellMesh                &mesh,
                     dealii::TimerOutput            &timer);
} // namespace Biface

#endif
