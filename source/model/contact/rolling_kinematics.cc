// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/rolling_kinematics.h>

namespace Biface
{
  using namespace dealii;

  RollingKinematics::RollingKinematics(const ShellMesh &mesh)
    : flow_lines(mesh), mesh(mesh)
  {}


  Point<3>
  RollingKinematics::position(const State &state, const unsigned int node) const
  {
    return mesh.deformed_position(
      state.displacement, mesh.nodes[node], Resultants::outer);
  }


  Tensor<1, 3>
  RollingKinematics::slope(const State &state, const unsigned int node) const
  {
    const FlowLines::Stencil &stencil = *flow_lines.at(node);
    return stencil.per_neighbor() * (position(state, stencil.neighbors[1]) -
                                     position(state, stencil.neighbors[0]));
  }


  Tensor<1, 3>
  RollingKinematics::relative_velocity(const State       &state,
                                       const Loads       &loads,
                                       const unsigned int node) const
  {
    if (!flow_lines.at(node))
      return {};
    return loads.rolling->relative_velocity(position(state, node),
                                            slope(state, node));
  }


  Tensor<1, 3>
  RollingKinematics::slip_velocity(const State       &state,
                                   const Loads       &loads,
                                   const unsigned int node) const
  {
    const Tensor<1, 3> n =
      loads.foundation->evaluate(position(state, node)).normal;
    const Tensor<1, 3> v = relative_velocity(state, loads, node);
    return v - (n * v) * n;
  }
} // namespace Biface
