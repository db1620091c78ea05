// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/forces/force_term.h>

namespace Biface
{
  namespace
  {
    /** The points of Simpson's rule in a step, with their weights: parts of the
     * way from its start to its end. */
    struct SimpsonPoint
    {
      double part, weight;
    };

    constexpr std::array<SimpsonPoint, 3> simpson{
      {{0, 1. / 6}, {0.5, 4. / 6}, {1, 1. / 6}}};
  } // namespace


  void
  ForceTerm::add_over_step(const CellState &start,
                           const CellState &end,
                           CellForces      &forces) const
  {
    const MixedElement::NodalVector change = end.V - start.V;
    CellForces                      at_point;
    for (const auto &[part, weight] : simpson)
      {
        at_point.with_tangent = forces.with_tangent && part > 0;
        at_point.clear();
        add(
          {end.index, end.cell, start.V + part * change, end.state, end.loads},
          at_point);
        forces.force += weight * at_point.force;
        forces.load += weight * at_point.load;
        forces.square += weight * at_point.square;
        if (at_point.with_tangent)
          for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
            for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
              forces.tangent[i][j] += weight * part * at_point.tangent[i][j];
      }
  }


  void
  ForceTerm::add_load_derivative_over_step(
    const CellState           &start,
    const CellState           &end,
    const LoadRates           &rates,
    MixedElement::NodalVector &force) const
  {
    const MixedElement::NodalVector change = end.V - start.V;
    for (const auto &[part, weight] : simpson)
      {
        MixedElement::NodalVector at_point;
        add_load_derivative(
          {end.index, end.cell, start.V + part * change, end.state, end.loads},
          rates,
          at_point);
        force += weight * at_point;
      }
  }
} // namespace Biface
