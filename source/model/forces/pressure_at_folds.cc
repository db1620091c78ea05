// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/pressure_at_folds.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

  PressureAtFolds::PressureAtFolds(const ShellMesh    &mesh,
                                   const PressureLoad &pressure)
    : face(pressure.face)
    , gaps(pressure.kind == PressureKind::follower
             ? gaps_at_folds(mesh, pressure.face)
             : std::vector<GapAtFold>())
  {
    const std::vector<double> at_nodes = pressure.values(mesh);
    for (const GapAtFold &gap : gaps)
      {
        distribution.emplace_back();
        for (unsigned int v = 0; v < 4; ++v)
          distribution.back()[v] =
            at_nodes[gap.element.nodes[gap.is_triangle && v == 3 ? 2 : v]];
      }
  }


  std::vector<const Cell *>
  PressureAtFolds::elements() const
  {
    std::vector<const Cell *> result;
    for (const GapAtFold &gap : gaps)
      result.push_back(&gap.element);
    return result;
  }


  FollowerPressure
  PressureAtFolds::unit_pressure(const CellState &at) const
  {
    const GapAtFold &gap = gaps[at.index];
    return FollowerPressure(gap.element.geometry,
                            gap.displacements(at.V),
                            face,
                            distribution[at.index]);
  }


  void
  PressureAtFolds::add(const CellState &at, CellForces &forces) const
  {
    const GapAtFold       &gap  = gaps[at.index];
    const FollowerPressure unit = unit_pressure(at);
    forces.load += at.loads.pressure * gap.at_unknowns(unit.force());
    if (!forces.with_tangent)
      return;
    MixedElement::NodalMatrix derivative{};
    unit.add_derivative(-at.loads.pressure, derivative);
    gap.add_at_unknowns(derivative, forces.tangent);
  }


  void
  PressureAtFolds::add_load_derivative(const CellState           &at,
                                       const LoadRates           &rates,
                                       MixedElement::NodalVector &force) const
  {
    force +=
      rates.pressure * gaps[at.index].at_unknowns(unit_pressure(at).force());
  }


  bool
  PressureAtFolds::is_symmetric(const Loads &loads) const
  {
    return gaps.empty() || loads.pressure == 0;
  }
} // namespace Biface
