// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/viscous_damping.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/state.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n = MixedElement::n_dofs;

    /** What the term remembers of a cell: first the displacements, then the
     * tractions. */
    MixedElement::NodalVector
    remembered(const State       &state,
               const unsigned int cell,
               const unsigned int first)
    {
      const Table<2, double>   &at_cells = state.terms.at("damping").at_cells;
      MixedElement::NodalVector values;
      for (unsigned int i = 0; i < n; ++i)
        values[i] = at_cells(cell, first + i);
      return values;
    }
  } // namespace


  bool
  ViscousDamping::is_active(const State &state)
  {
    return state.terms.count("damping") > 0;
  }


  bool
  ViscousDamping::acts_on(const unsigned int cell,
                          const State       &state,
                          const Loads       &loads) const
  {
    const bool in_equilibrium = loads.part_of_stage == 0;
    return mesh.cells[cell].is_wall && is_active(state) &&
           (in_equilibrium || loads.damping > 0);
  }


  void
  ViscousDamping::add(const CellState &at, CellForces &forces) const
  {
    // half of the dashpots on each face: the same stiffness for the mean and
    // for half the difference
    const bool in_equilibrium = at.loads.part_of_stage == 0;
    // outside of a step the tractions of the last one, in which its end is in
    // equilibrium
    const double per_area =
      in_equilibrium ? 1. : -at.loads.damping / at.loads.part_of_stage;
    MixedElement::NodalVector force =
      in_equilibrium ? remembered(at.state, at.index, n)
                     : at.V - remembered(at.state, at.index, 0);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double factor =
          per_area * at.cell.geometry.vertex_areas[i / (n / 4)];
        force[i] *= factor;
        if (!in_equilibrium && forces.with_tangent)
          forces.tangent[i][i] -= factor;
      }
    forces.force += force;
    forces.square += force.norm_square();
  }


  void
  ViscousDamping::start_stage(const Loads &loads, State &state) const
  {
    const bool was_damped = is_active(state);
    if (loads.damping == 0 && !was_damped)
      return;
    // the tractions of the stage before belong to its last state
    Table<2, double> &at_cells = state.terms[name()].at_cells;
    if (!was_damped)
      at_cells.reinit(mesh.cells.size(), 2 * n);
    for (const unsigned int c : mesh.walls)
      {
        const auto V = mesh.cell_values(state.displacement, mesh.cells[c]);
        for (unsigned int i = 0; i < n; ++i)
          at_cells(c, i) = V[i];
      }
  }


  void
  ViscousDamping::commit_step(const State &,
                              const Loads        &loads,
                              const TimeInterval &time,
                              State              &after) const
  {
    if (loads.damping == 0)
      {
        after.terms.erase(name());
        return;
      }
    Table<2, double> &at_cells = after.terms.at(name()).at_cells;
    for (const unsigned int c : mesh.walls)
      {
        const auto V = mesh.cell_values(after.displacement, mesh.cells[c]);
        for (unsigned int i = 0; i < n; ++i)
          {
            at_cells(c, n + i) = -loads.damping * (V[i] - at_cells(c, i)) /
                                 (time.end - time.start);
            at_cells(c, i) = V[i];
          }
      }
  }
} // namespace Biface
