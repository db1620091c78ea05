// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/rolling_friction.h>

namespace Biface
{
  using namespace dealii;

  RollingFriction::RollingFriction(const ShellMesh        &mesh,
                                   const ContactCondition &condition)
    : flow_lines(mesh), mesh(mesh), condition(condition)
  {}


  Point<3>
  RollingFriction::position(const State &state, const unsigned int node) const
  {
    return mesh.deformed_position(
      state.displacement, mesh.nodes[node], Resultants::outer);
  }


  Tensor<1, 3>
  RollingFriction::slope(const State &state, const unsigned int node) const
  {
    const FlowLines::Stencil &stencil = *flow_lines.at(node);
    return stencil.per_neighbor() * (position(state, stencil.neighbors[1]) -
                                     position(state, stencil.neighbors[0]));
  }


  Tensor<1, 3>
  RollingFriction::relative_velocity(const State       &state,
                                     const Loads       &loads,
                                     const unsigned int node) const
  {
    if (!flow_lines.at(node))
      return {};
    return loads.rolling->relative_velocity(slope(state, node));
  }


  bool
  RollingFriction::slips(const State       &state,
                         const Loads       &loads,
                         const unsigned int node) const
  {
    const Tensor<1, 3> n =
      loads.foundation->evaluate(position(state, node)).normal;
    const Tensor<1, 3> v = relative_velocity(state, loads, node);
    return SlipVelocityLaw(*loads.friction, loads.rolling->critical_velocity)
      .slips(v - (n * v) * n);
  }


  RollingFriction::Traction
  RollingFriction::traction(const State       &state,
                            const Loads       &loads,
                            const unsigned int node) const
  {
    Traction    result;
    const auto &stencil = flow_lines.at(node);
    if (!stencil)
      return result;
    const Rolling        &rolling = *loads.rolling;
    const FoundationPoint at =
      loads.foundation->evaluate(position(state, node));
    const Tensor<1, 3> &n        = at.normal;
    const Tensor<2, 3>  gradient = Tensor<2, 3>(at.normal_gradient);
    const Tensor<1, 3>  slope    = this->slope(state, node);
    const Tensor<1, 3>  v        = rolling.relative_velocity(slope);
    const Tensor<2, 3>  tangential =
      Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n);

    const SlipVelocityLaw law(*loads.friction, rolling.critical_velocity);
    const double          lambda = state.multipliers[node][0];
    const double          exact  = condition.multiplier(at.clearance);
    const SlipVelocityLaw::Traction friction =
      law.traction(tangential * v, -lambda);
    const Tensor<2, 3> per_velocity = friction.per_slip * tangential;

    result.value = friction.value + (lambda - exact) * friction.per_pressure;
    result.stiffness = friction.per_slip *
                         ((n * v) * gradient + outer_product(n, gradient * v)) -
                       outer_product(friction.per_pressure,
                                     condition.multiplier_stiffness() * n);
    result.stiffness_of_neighbors[1] =
      stencil->per_neighbor() * rolling.angular_velocity * per_velocity;
    result.stiffness_of_neighbors[0] = -result.stiffness_of_neighbors[1];
    result.per_angular_velocity      = -per_velocity * slope;
    return result;
  }
} // namespace Biface
