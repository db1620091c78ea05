// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/contact/friction.h>
#include <biface/contact/rigid_body.h>
#include <biface/contact/rolling.h>

namespace Biface
{
  using namespace dealii;

  WheelAxes::WheelAxes(const Tensor<1, 3> &direction)
    : up(-direction / direction.norm())
  {
    const Tensor<1, 3> axle({0., 1., 0.});
    left = axle - (axle * up) * up;
    left /= left.norm();
    forward = cross_product_3d(left, up);
  }


  bool
  WheelAxes::fit(const Tensor<1, 3> &direction)
  {
    return std::abs(direction[1]) < 0.9 * direction.norm();
  }


  GroundMotion
  GroundMotion::under_wheel(const RigidBody &ground,
                            const double     speed,
                            const double     slip_angle)
  {
    GroundMotion       result;
    const Point<3>     apex = ground.apex();
    const Tensor<1, 3> down = ground.evaluate(apex).normal;
    if (const auto drum = ground.cylinder())
      {
        // -V/R a x (x - x_a) of section 10 of doc/theory.md at the apex, where
        // x - x_a = -R down
        result.velocity = speed * cross_product_3d(drum->axis, down);
        result.spin     = -speed / drum->radius * drum->axis;
        result.point    = apex;
      }
    else
      {
        const WheelAxes axes(down);
        // in the frame of the axle the ground moves backward, at the slip angle
        result.velocity = -speed * (std::cos(slip_angle) * axes.forward +
                                    std::sin(slip_angle) * axes.left);
      }
    return result;
  }


  RigidBody
  ground_at_slip_angle(const RigidBody &ground, const double slip_angle)
  {
    // right-handed about the direction, that is downward
    return ground.cylinder() ? ground.displaced({}, -slip_angle, ground.apex())
                             : ground;
  }


  SlipVelocityLaw::Traction
  SlipVelocityLaw::traction(const Tensor<1, 3> &slip,
                            const double        pressure) const
  {
    const double speed = slip.norm();
    const double root  = std::hypot(speed, law.critical_velocity());
    Traction     result;
    // at rest without a critical velocity there is no direction of slip
    if (root == 0)
      return result;
    const Tensor<1, 3>       direction = slip / root;
    const FrictionLaw::Limit limit     = law.limit(pressure, speed);
    result.value                       = -limit.value * direction;
    result.per_slip                    = -limit.value / root *
                      (Tensor<2, 3>(unit_symmetric_tensor<3>()) -
                       outer_product(direction, direction));
    // the coefficient changes with the length of the slip velocity alone
    if (speed > 0)
      result.per_slip -=
        limit.per_speed * outer_product(direction, slip / speed);
    result.per_pressure = -limit.per_pressure * direction;
    return result;
  }


  bool
  SlipVelocityLaw::slips(const Tensor<1, 3> &slip) const
  {
    return slip.norm() > law.critical_velocity();
  }
} // namespace Biface
