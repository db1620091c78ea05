// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/pressure_load.h>
#include <biface/model/forces/pressure_on_directors.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  PressureOnDirectors::PressureOnDirectors(const ShellMesh    &mesh,
                                           const PressureLoad &pressure)
    : directors(mesh, pressure.face), distribution(pressure.values(mesh))
  {}


  double
  PressureOnDirectors::share(const Cell &cell) const
  {
    double sum = 0;
    for (const unsigned int node : cell.nodes)
      sum += distribution[node];
    return sum / cell.nodes.size();
  }


  void
  PressureOnDirectors::add(const CellState &at, CellForces &forces) const
  {
    const double pressure = at.loads.pressure * share(at.cell);
    directors.add_force(pressure, at.cell, at.V, forces.load);
    if (forces.with_tangent)
      directors.add_derivative(-pressure, at.cell, at.V, forces.tangent);
  }


  void
  PressureOnDirectors::add_over_step(const CellState &start,
                                     const CellState &end,
                                     CellForces      &forces) const
  {
    const double pressure = end.loads.pressure * share(end.cell);
    directors.add_mean_force(pressure, end.cell, start.V, end.V, forces.load);
    // what is left out is of the size of the displacement in the step
    if (forces.with_tangent)
      directors.add_derivative(
        -pressure / 2, end.cell, 0.5 * (start.V + end.V), forces.tangent);
  }


  void
  PressureOnDirectors::add_load_derivative(
    const CellState           &at,
    const LoadRates           &rates,
    MixedElement::NodalVector &force) const
  {
    directors.add_force(rates.pressure * share(at.cell), at.cell, at.V, force);
  }
} // namespace Biface
