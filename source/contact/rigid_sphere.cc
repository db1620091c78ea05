// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/contact/rigid_sphere.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  RigidSphere::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Radius",
                      radius,
                      "Radius of the sphere; negative for a hollow one, which "
                      "the shell presses on from within. Not 0. Unit: length.",
                      Patterns::Double());
  }


  RigidSphere::RigidSphere(const Path &path, const Parameters &parameters)
    : RigidSphere(path, parameters.radius)
  {
    check_not_zero("Contact/Sphere/Radius", radius);
  }


  FoundationPoint
  RigidSphere::evaluate(const Point<3> &x) const
  {
    // rho, the distance from the center, has the sign of R. The clearance is
    // rho - R, written as (rho^2 - R^2)/(rho + R): this keeps its digits where
    // R is large
    const Tensor<1, 3> y         = x - point;
    const Tensor<1, 3> to_center = radius * direction - y;
    const double       rho       = std::copysign(to_center.norm(), radius);
    const Tensor<1, 3> n         = to_center / rho;
    return {(y * y - 2 * radius * (y * direction)) / (rho + radius),
            n,
            (symmetrize(outer_product(n, n)) - unit_symmetric_tensor<3>()) /
              rho};
  }


  double
  RigidSphere::travel_to(const Point<3> &x) const
  {
    const Tensor<1, 3> y      = x - point;
    const double       height = y * direction;
    const double       square = (y - height * direction).norm_square();
    if (square > radius * radius)
      return std::copysign(std::numeric_limits<double>::infinity(), radius);
    // the sphere recedes by R - sqrt(R^2 - square), written like the clearance
    const double root =
      std::copysign(std::sqrt(radius * radius - square), radius);
    return square / (radius + root) - height;
  }
} // namespace Biface
