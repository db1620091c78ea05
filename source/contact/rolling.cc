// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

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


  Tensor<1, 3>
  Rolling::ground_velocity_of(const WheelAxes &axes,
                              const double     speed,
                              const double     slip_angle)
  {
    return -speed * (std::cos(slip_angle) * axes.forward +
                     std::sin(slip_angle) * axes.left);
  }


  SlipVelocityLaw::Traction
  SlipVelocityLaw::traction(const Tensor<1, 3> &slip,
                            const double        pressure) const
  {
    const double root = std::hypot(slip.norm(), critical_velocity);
    Traction     result;
    if (root == 0)
      return result;
    const Tensor<1, 3> direction = slip / root;
    const double       limit     = law.limit(pressure);
    result.value                 = -limit * direction;
    result.per_slip              = -limit / root *
                      (Tensor<2, 3>(unit_symmetric_tensor<3>()) -
                       outer_product(direction, direction));
    result.per_pressure = -law.limit_derivative(pressure) * direction;
    return result;
  }
} // namespace Biface
