// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/rolling.h>
#include <biface/model/contact/friction_by_slip_velocity.h>

namespace Biface
{
  using namespace dealii;

  void
  FrictionBySlipVelocity::start_stage(State &state) const
  {
    for (unsigned int n = 0; n < state.grips.size(); ++n)
      forget_stick_point(state, n);
  }


  bool
  FrictionBySlipVelocity::decide(State               &state,
                                 const Loads         &loads,
                                 const NodeInContact &at,
                                 const Tensor<1, 3> & /*last*/) const
  {
    const bool slips = SlipVelocityLaw(law).slips(
      kinematics.slip_velocity(state, loads, at.node));
    state.grips[at.node] = (slips ? Grip::slip : Grip::stick);
    return false;
  }


  Tensor<1, 3>
  FrictionBySlipVelocity::traction(const State         &state,
                                   const Loads         &loads,
                                   const NodeInContact &at) const
  {
    LinearizedTraction result;
    linearize(state, loads, at, result);
    return result.value;
  }


  void
  FrictionBySlipVelocity::linearize(const State         &state,
                                    const Loads         &loads,
                                    const NodeInContact &at,
                                    LinearizedTraction  &result) const
  {
    const auto &stencil = kinematics.flow_lines.at(at.node);
    if (!stencil)
      return;
    const Rolling      &rolling  = *loads.rolling;
    const Tensor<1, 3> &n        = at.foundation.normal;
    const Tensor<2, 3>  gradient = Tensor<2, 3>(at.foundation.normal_gradient);
    const Tensor<1, 3>  slope    = kinematics.slope(state, at.node);
    const Tensor<1, 3>  v        = rolling.relative_velocity(at.x, slope);
    const Tensor<2, 3>  tangential =
      Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n);

    const double lambda = state.multipliers[at.node][0];
    const double exact  = condition.multiplier(at.foundation.clearance);
    const SlipVelocityLaw::Traction friction =
      SlipVelocityLaw(law).traction(tangential * v, -lambda);
    result.per_velocity = friction.per_slip * tangential;

    // the derivative of the velocity of the ground by the position
    Tensor<2, 3> ground_gradient;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Tensor<1, 3> e;
        e[j]                      = 1;
        const Tensor<1, 3> column = cross_product_3d(rolling.ground.spin, e);
        for (unsigned int i = 0; i < 3; ++i)
          ground_gradient[i][j] = column[i];
      }
    result.value += friction.value + (lambda - exact) * friction.per_pressure;
    result.stiffness += friction.per_slip * ((n * v) * gradient +
                                             outer_product(n, gradient * v)) +
                        result.per_velocity * ground_gradient -
                        outer_product(friction.per_pressure,
                                      condition.multiplier_stiffness() * n);
    result.stiffness_of_neighbors[1] =
      stencil->per_neighbor() * rolling.angular_velocity * result.per_velocity;
    result.stiffness_of_neighbors[0] = -result.stiffness_of_neighbors[1];
    result.per_angular_velocity      = -result.per_velocity * slope;
  }


  void
  FrictionBySlipVelocity::commit_step(State               &state,
                                      const Loads         &loads,
                                      const NodeInContact &at) const
  {
    state.stick_points[at.node] = loads.foundation->at_rest(
      Point<3>(at.x - law.elastic_slip(traction(state, loads, at))));
  }


  std::shared_ptr<const TangentialLaw>
  FrictionBySlipVelocity::with_critical_velocity(const double velocity) const
  {
    return std::make_shared<const FrictionBySlipVelocity>(
      law.with_critical_velocity(velocity), condition, kinematics);
  }
} // namespace Biface
