// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <biface/base/errors.h>
#include <biface/contact/body_section.h>
#include <biface/contact/body_shapes.h>
#include <biface/contact/ground_parameters.h>
#include <biface/input/entry_declarations.h>
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


  BodyShape::BodyShape(const TravelLine &line)
    : direction(line.direction / line.direction.norm()), point(line.point)
  {}


  double
  BodyShape::travel_to(const Point<3> & /*x*/) const
  {
    Assert(false, ExcPureFunctionCalled());
    return std::numeric_limits<double>::quiet_NaN();
  }


  void
  SphereParameters::add_parameters(EntryDeclarations &prm)
  {
    add_optional_number(
      prm,
      "Radius",
      radius,
      "none",
      "Radius of the sphere; negative for a hollow sphere with the "
      "shell inside. A number other than 0, which 'Foundation "
      "= sphere' needs.",
      Unit("length"));
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
  DrumParameters::add_parameters(EntryDeclarations &prm)
  {
    add_optional_number(
      prm,
      "Radius",
      radius,
      "none",
      "Radius of the drum; negative for a hollow drum with the "
      "shell inside. A number other than 0, which 'Foundation "
      "= drum' needs.",
      Unit("length"));
    prm.add_parameter("Axis",
                      axis,
                      "Direction of the axis of the drum: components x, y, z "
                      "of any nonzero vector, not parallel to 'Direction'.",
                      Unit::none());
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
    // the section is a sphere, which is curved in both directions, a drum only
    // across its axis
    SymmetricTensor<2, 3> &G = result.normal_gradient;
    G -= (axis * (G * axis)) * symmetrize(outer_product(axis, axis));
    return result;
  }


  double
  RigidDrum::travel_to(const Point<3> &x) const
  {
    // the section sees only the part of the travel across the axis
    return section.travel_to(x - (axis * (x - point)) * axis) /
           (section.direction * direction);
  }


  ExtrudedBody::ExtrudedBody(const TravelLine                  &line,
                             const Tensor<1, 3>                &axis,
                             std::shared_ptr<const BodySection> section)
    : BodyShape(line)
    , across(cross_product_3d(direction, axis))
    , up(-direction)
    , section(std::move(section))
  {}


  BodyPoint
  ExtrudedBody::evaluate(const Point<3> &x) const
  {
    const Tensor<1, 3> y     = x - point;
    const SectionPoint at    = section->evaluate({y * across, y * up});
    const auto        &g     = at.gradient;
    const Tensor<1, 3> along = g[0] * up - g[1] * across;
    return {at.distance,
            -(g[0] * across + g[1] * up),
            -at.curvature * symmetrize(outer_product(along, along))};
  }


  RevolvedBody::RevolvedBody(const TravelLine                  &line,
                             const Tensor<1, 3>                &axis,
                             std::shared_ptr<const BodySection> section)
    : BodyShape(line), axis(axis), section(std::move(section))
  {}


  BodyPoint
  RevolvedBody::evaluate(const Point<3> &x) const
  {
    const Tensor<1, 3> y      = x - point;
    const double       height = y * axis;
    const Tensor<1, 3> arm    = y - height * axis;
    const double       radius = arm.norm();
    // any direction on the axis itself
    Tensor<1, 3> outward = arm / radius;
    if (!(radius > 0))
      {
        outward = cross_product_3d(axis, Tensor<1, 3>({1., 0., 0.}));
        if (outward.norm() < 0.1)
          outward = cross_product_3d(axis, Tensor<1, 3>({0., 1., 0.}));
        outward /= outward.norm();
      }
    const SectionPoint at    = section->evaluate({height, radius});
    const auto        &g     = at.gradient;
    const Tensor<1, 3> along = g[0] * outward - g[1] * axis,
                       round = cross_product_3d(axis, outward);
    // there, both curvatures are the same
    const double around = (radius > 0 ? g[1] / radius : at.curvature);
    return {at.distance,
            -(g[0] * axis + g[1] * outward),
            -at.curvature * symmetrize(outer_product(along, along)) -
              around * symmetrize(outer_product(round, round))};
  }
} // namespace Biface
