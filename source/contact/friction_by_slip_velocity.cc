// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/friction_by_slip_velocity.h>
#include <biface/contact/rolling.h>

namespace Biface
{
  using namespace dealii;

  bool
  FrictionBySlipVelocity::decide(ContactState         &state,
                                 const PointInContact &at,
                                 const Tensor<1, 3> & /*last*/) const
  {
    const bool slips = SlipVelocityLaw(law).slips(at.slip_velocity());
    state.statuses[at.point] =
      (slips ? ContactStatus::slip : ContactStatus::stick);
    // the traction is smooth in the slip velocity: the status is a result, and
    // its change asks for no further iteration
    return false;
  }


  Tensor<1, 3>
  FrictionBySlipVelocity::traction(const ContactState   &state,
                                   const PointInContact &at) const
  {
    LinearizedTraction result;
    linearize(state, at, result);
    return result.value;
  }


  void
  FrictionBySlipVelocity::linearize(const ContactState   &state,
                                    const PointInContact &at,
                                    LinearizedTraction   &result) const
  {
    // only nodes at the rim of the ghost cells lack a neighbor around the axle;
    // no own cell contains them
    if (!at.particle)
      return;
    const Rolling      &rolling  = at.particle->rolling;
    const Tensor<1, 3> &n        = at.at_body.normal;
    const Tensor<2, 3>  gradient = Tensor<2, 3>(at.at_body.normal_gradient);
    const Tensor<1, 3>  slope    = at.particle->slope;
    const Tensor<1, 3>  v        = at.relative_velocity();
    const Tensor<2, 3>  tangential =
      Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n);

    const double lambda = state.multipliers[at.point][0];
    const double exact  = condition.multiplier(at.at_body.clearance);
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
    // the limit is that of the multiplier of the iterate, with its linear
    // change to the pressure of the clearance
    result.value += friction.value + (lambda - exact) * friction.per_pressure;
    // minus the derivative: the tangent plane turns with the position, the
    // ground has another velocity there, and the pressure follows the clearance
    result.stiffness +=
      friction.per_slip *
        ((n * v) * gradient + outer_product(n, gradient * v)) +
      result.per_velocity * ground_gradient -
      outer_product(friction.per_pressure, condition.penalty_stiffness() * n);
    // the slope is a difference of the positions of both neighbors
    result.stiffness_of_neighbors[1] = at.particle->per_neighbor *
                                       rolling.angular_velocity *
                                       result.per_velocity;
    result.stiffness_of_neighbors[0] = -result.stiffness_of_neighbors[1];
    result.per_angular_velocity      = -result.per_velocity * slope;
  }

} // namespace Biface
