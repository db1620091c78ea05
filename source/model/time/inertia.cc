// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/equations/mass_matrix.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/inertia.h>

namespace Biface
{
  bool
  Inertia::acts_on(const unsigned int cell,
                   const State       &state,
                   const Loads & /*loads*/) const
  {
    return state.step && mesh.cells[cell].is_layer;
  }


  bool
  Inertia::is_symmetric(const Loads &loads) const
  {
    return !loads.rolling;
  }


  void
  Inertia::add_over_step(const CellState &start,
                         const CellState &end,
                         CellForces      &forces) const
  {
    const StepInTime &step = *end.state.step;
    const auto        v_0  = mesh.cell_values(start.state.velocity, end.cell);
    const auto        M    = cell_mass(mesh, end.cell);
    const double      dt   = step.duration,
                 per_displacement = (2 / dt + step.damping.of_mass) / dt;

    // (v_1 - v_0)/dt, with v_1 from the displacements, and the damping of the
    // mean velocity
    MixedElement::NodalVector acceleration =
      per_displacement * (end.V - start.V) - 2 / dt * v_0;
    if (step.of_supports.size() > 0)
      acceleration += mesh.cell_values(step.of_supports, end.cell);
    MixedElement::NodalVector force;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        force[i] += M[i][j] * acceleration[j];
    forces.force -= force;
    forces.square += force.norm_square();
    if (forces.with_tangent)
      for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
        for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
          forces.tangent[i][j] += per_displacement * M[i][j];
  }
} // namespace Biface
