// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/rolling_friction.h>

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
    return loads.rolling->relative_velocity(position(state, node),
                                            slope(state, node));
  }


  Tensor<1, 3>
  RollingFriction::slip_velocity(const State       &state,
                                 const Loads       &loads,
                                 const unsigned int node) const
  {
    const Tensor<1, 3> n =
      loads.foundation->evaluate(position(state, node)).normal;
    const Tensor<1, 3> v = relative_velocity(state, loads, node);
    return v - (n * v) * n;
  }


  bool
  RollingFriction::slips(const State       &state,
                         const Loads       &loads,
                         const unsigned int node) const
  {
    return SlipVelocityLaw(*loads.friction)
      .slips(slip_velocity(state, loads, node));
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
    const Rolling        &rolling  = *loads.rolling;
    const Point<3>        x        = position(state, node);
    const FoundationPoint at       = loads.foundation->evaluate(x);
    const Tensor<1, 3>   &n        = at.normal;
    const Tensor<2, 3>    gradient = Tensor<2, 3>(at.normal_gradient);
    const Tensor<1, 3>    slope    = this->slope(state, node);
    const Tensor<1, 3>    v        = rolling.relative_velocity(x, slope);
    const Tensor<2, 3>    tangential =
      Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n);

    const SlipVelocityLaw           law(*loads.friction);
    const double                    lambda = state.multipliers[node][0];
    const double                    exact  = condition.multiplier(at.clearance);
    const SlipVelocityLaw::Traction friction =
      law.traction(tangential * v, -lambda);
    result.per_velocity = friction.per_slip * tangential;

    // of the velocity of the ground by the position
    Tensor<2, 3> ground_gradient;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Tensor<1, 3> e;
        e[j]                      = 1;
        const Tensor<1, 3> column = cross_product_3d(rolling.ground.spin, e);
        for (unsigned int i = 0; i < 3; ++i)
          ground_gradient[i][j] = column[i];
      }

    result.value = friction.value + (lambda - exact) * friction.per_pressure;
    result.stiffness = friction.per_slip *
                         ((n * v) * gradient + outer_product(n, gradient * v)) +
                       result.per_velocity * ground_gradient -
                       outer_product(friction.per_pressure,
                                     condition.multiplier_stiffness() * n);
    result.stiffness_of_neighbors[1] =
      stencil->per_neighbor() * rolling.angular_velocity * result.per_velocity;
    result.stiffness_of_neighbors[0] = -result.stiffness_of_neighbors[1];
    result.per_angular_velocity      = -result.per_velocity * slope;
    return result;
  }
} // namespace Biface
