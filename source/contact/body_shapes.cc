// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>
#include <string>

#include <biface/base/errors.h>
#include <biface/contact/body_shapes.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    double
    given_radius(const std::string &entry, const std::optional<double> &radius)
    {
      if (!radius)
        throw InputError(entry, "none", "it must be a number other than 0");
      check_not_zero(entry, *radius);
      return *radius;
    }
  } // namespace


  void
  RigidSphere::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_optional_number(
      prm,
      "Radius",
      radius,
      "none",
      "Radius of the sphere; negative for a hollow sphere with the "
      "shell inside. A number other than 0, which 'Foundation "
      "= sphere' needs. Unit: length.");
  }


  RigidSphere::RigidSphere(const TravelLine &line, const Parameters &parameters)
    : RigidSphere(line,
                  given_radius("Contact/Sphere/Radius", parameters.radius))
  {}


  BodyPoint
  RigidSphere::evaluate(const Point<3> &x) const
  {
    // rho, the distance from the center, has the sign of R. The clearance is
    // rho - R, written as (rho^2 - R^2)/(rho + R) to avoid cancellation if R is
    // large
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


  void
  RigidDrum::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_optional_number(
      prm,
      "Radius",
      radius,
      "none",
      "Radius of the drum; negative for a hollow drum with the "
      "shell inside. A number other than 0, which 'Foundation "
      "= drum' needs. Unit: length.");
    prm.add_parameter("Axis",
                      axis,
                      "Direction of the axis of the drum: components x, y, z "
                      "of any nonzero vector, not parallel to 'Direction'.");
  }


  RigidDrum::RigidDrum(const TravelLine &line, const Parameters &parameters)
    : BodyShape(line)
    , axis(unit_vector("Contact/Drum/Axis", parameters.axis))
    , radius(given_radius("Contact/Drum/Radius", parameters.radius))
    , section({direction - (direction * axis) * axis, point}, radius)
  {
    check_not_parallel(
      "Contact/Drum/Axis", parameters.axis, "Direction", direction);
  }


  BodyPoint
  RigidDrum::evaluate(const Point<3> &x) const
  {
    BodyPoint result = section.evaluate(x - (axis * (x - point)) * axis);
    SymmetricTensor<2, 3> &G = result.normal_gradient;
    G -= (axis * (G * axis)) * symmetrize(outer_product(axis, axis));
    return result;
  }


  double
  RigidDrum::travel_to(const Point<3> &x) const
  {
    return section.travel_to(x - (axis * (x - point)) * axis) /
           (section.direction * direction);
  }
} // namespace Biface
