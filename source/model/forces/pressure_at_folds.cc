// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/model/forces/pressure_at_folds.h>
#include <biface/model/mesh/fold_side.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

  PressureAtFolds::PressureAtFolds(const ShellMesh    &mesh,
                                   const PressureLoad &pressure)
    : face(pressure.face)
  {
    const std::vector<double> distribution = pressure.values(mesh);
    if (pressure.kind == PressureKind::dead)
      return;
    for (const FoldSide &fold : mesh.folds)
      for (const auto &wedge : fold.wedges[face])
        {
          const FoldSide::Part &one = fold.parts[wedge[0]],
                               &two = fold.parts[wedge[1]];
          // counterclockwise between the sides of both cells
          const unsigned int a = (one.is_reversed ? 1 : 0), b = 1 - a;
          add_gap(mesh,
                  distribution,
                  {one.nodes[b], one.nodes[a], two.nodes[b], two.nodes[a]});
        }
    for (const std::vector<unsigned int> &corner : mesh.corners[face])
      for (unsigned int k = 1; k + 1 < corner.size(); ++k)
        add_gap(mesh, distribution, {corner[0], corner[k], corner[k + 1]});
  }


  void
  PressureAtFolds::add_gap(const ShellMesh                 &mesh,
                           const std::vector<double>       &distribution,
                           const std::vector<unsigned int> &vertices)
  {
    std::array<unsigned int, 4> nodes;
    std::copy(vertices.begin(), vertices.end(), nodes.begin());
    Gap gap;
    gap.is_triangle = (vertices.size() == 3);
    // the unknowns of an element are those of different nodes
    if (gap.is_triangle)
      {
        const auto &others = mesh.neighbors[vertices[0]];
        nodes[3]           = *std::find_if(
          others.begin(), others.end(), [&](const unsigned int n) {
            return std::find(vertices.begin(), vertices.end(), n) ==
                   vertices.end();
          });
      }
    gap.element = element_between(mesh, nodes);
    for (unsigned int v = 0; v < 4; ++v)
      gap.distribution[v] = distribution[nodes[v]];
    if (gap.is_triangle)
      {
        gap.distribution[3] = gap.distribution[2];
        gap.element.geometry.stations =
          element_between(mesh, {{nodes[0], nodes[1], nodes[2], nodes[2]}})
            .geometry.stations;
      }
    gaps.push_back(gap);
  }


  std::vector<const Cell *>
  PressureAtFolds::elements() const
  {
    std::vector<const Cell *> result;
    for (const Gap &gap : gaps)
      result.push_back(&gap.element);
    return result;
  }


  FollowerPressure
  PressureAtFolds::unit_pressure(const CellState &at) const
  {
    const Gap                &gap = gaps[at.index];
    MixedElement::NodalVector V   = at.V;
    if (gap.is_triangle)
      for (unsigned int i = 0; i < 3; ++i)
        for (const auto part :
             {MixedElement::mean, MixedElement::half_difference})
          V[MixedElement::dof(3, i, part)] = V[MixedElement::dof(2, i, part)];
    return FollowerPressure(gap.element.geometry, V, face, gap.distribution);
  }


  namespace
  {
    /** The unknown of the third vertex that takes the place of an unknown of
     * the fourth one. */
    unsigned int
    at_third_vertex(const unsigned int dof)
    {
      constexpr unsigned int n_of_vertex = MixedElement::n_dofs / 4;
      return dof < 3 * n_of_vertex ? dof : dof - n_of_vertex;
    }
  } // namespace


  MixedElement::NodalVector
  PressureAtFolds::force_on(const Gap &gap, const FollowerPressure &pressure)
  {
    MixedElement::NodalVector force;
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      force[gap.is_triangle ? at_third_vertex(i) : i] += pressure.force()[i];
    return force;
  }


  void
  PressureAtFolds::add(const CellState &at, CellForces &forces) const
  {
    const Gap             &gap  = gaps[at.index];
    const FollowerPressure unit = unit_pressure(at);
    forces.load += at.loads.pressure * force_on(gap, unit);
    if (!forces.with_tangent)
      return;
    if (!gap.is_triangle)
      {
        unit.add_derivative(-at.loads.pressure, forces.tangent);
        return;
      }
    MixedElement::NodalMatrix own{};
    unit.add_derivative(-at.loads.pressure, own);
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        forces.tangent[at_third_vertex(i)][at_third_vertex(j)] += own[i][j];
  }


  void
  PressureAtFolds::add_load_derivative(const CellState           &at,
                                       const LoadRates           &rates,
                                       MixedElement::NodalVector &force) const
  {
    force += rates.pressure * force_on(gaps[at.index], unit_pressure(at));
  }


  bool
  PressureAtFolds::is_symmetric(const Loads &loads) const
  {
    return gaps.empty() || loads.pressure == 0;
  }
} // namespace Biface
