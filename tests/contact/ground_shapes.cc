// SPDX-License-Identifier: LGPL-2.1-or-later

// The clearance of a solid or hollow drum or sphere is the distance from its
// surface, the normal is minus its gradient, and the derivative of the normal
// is minus its second derivative; after the travel to a point the ground
// touches it. With a huge radius all agree with a plane to the last digits.

#include <biface/contact/body_shapes.h>
#include <biface/contact/ground_parameters.h>
#include <biface/contact/rigid_body.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  BodyShape::TravelLine
  line()
  {
    return {Tensor<1, 3>({2, 0.6, -0.4}), Point<3>(3, -1, 2)};
  }


  /** Points here and there, within a distance of about 3 of that of the line.
   */
  Point<3>
  some_point(const unsigned int i)
  {
    return line().point + Tensor<1, 3>({2 * std::sin(1 + 3.1 * i),
                                        2 * std::sin(2 + 5.3 * i),
                                        2 * std::sin(3 + 7.9 * i)});
  }


  /** @param distance from the surface, by the center or axis. */
  template <typename Distance>
  void
  test(const std::string                     &name,
       const std::shared_ptr<const BodyShape> shape,
       const Distance                        &distance)
  {
    const double    travel = 0.3, step = 1e-5;
    const RigidBody ground = RigidBody(shape).moved(travel);

    double clearance = 0, unit = 0, normal = 0, gradient = 0, touch = 0;
    for (unsigned int i = 0; i < 10; ++i)
      {
        const Point<3>  x  = some_point(i);
        const BodyPoint at = ground.evaluate(x);
        clearance          = std::max(
          clearance,
          std::abs(at.clearance - distance(x + travel * shape->direction)));
        unit = std::max(unit, std::abs(at.normal.norm() - 1));
        for (unsigned int j = 0; j < 3; ++j)
          {
            Tensor<1, 3> e;
            e[j]               = step;
            const auto forward = ground.evaluate(x + e);
            const auto back    = ground.evaluate(x - e);
            normal             = std::max(
              normal,
              std::abs((forward.clearance - back.clearance) / (2 * step) +
                       at.normal[j]));
            Tensor<1, 3> column;
            for (unsigned int k = 0; k < 3; ++k)
              column[k] = at.normal_gradient[k][j];
            gradient = std::max(
              gradient,
              ((forward.normal - back.normal) / (2 * step) - column).norm());
          }
        touch = std::max(
          touch, std::abs(ground.moved(ground.travel_to(x)).clearance(x)));
      }
    std::cout << name << std::endl;
    check_small("  clearance", clearance, 1e-13);
    check_small("  length of the normal", unit, 1e-14);
    check_small("  normal", normal, 1e-9);
    check_small("  gradient of the normal", gradient, 1e-9);
    check_small("  clearance where it touches", touch, 1e-13);
  }


  /** The maximum differences from a plane. */
  void
  compare_with_plane(const std::string &name, const BodyShape &shape)
  {
    const RigidPlane plane(line());
    double           clearance = 0, normal = 0, travel = 0;
    for (unsigned int i = 0; i < 10; ++i)
      {
        const Point<3> x     = some_point(i);
        const auto     point = shape.evaluate(x), flat = plane.evaluate(x);
        clearance =
          std::max(clearance, std::abs(point.clearance - flat.clearance));
        normal = std::max(normal, (point.normal - flat.normal).norm());
        travel =
          std::max(travel, std::abs(shape.travel_to(x) - plane.travel_to(x)));
      }
    std::cout << name << std::endl;
    check_small("  clearance", clearance, 1e-14);
    check_small("  normal", normal, 1e-14);
    check_small("  travel", travel, 1e-14);
  }
} // namespace


int
main()
{
  const Tensor<1, 3> direction = line().direction / line().direction.norm();
  const Tensor<1, 3> axis      = Tensor<1, 3>({0.2, 0.8, 0.6});
  const Tensor<1, 3> unit_axis = axis / axis.norm();
  Tensor<1, 3>       across = direction - (direction * unit_axis) * unit_axis;
  across /= across.norm();

  for (const double radius : {4., -7.})
    {
      const std::string kind = (radius > 0 ? "full" : "hollow");
      test(kind + " sphere",
           std::make_shared<RigidSphere>(line(), radius),
           [&](const Point<3> &x) {
             const Point<3> center = line().point + radius * direction;
             return std::copysign((x - center).norm(), radius) - radius;
           });

      RigidDrum::Parameters parameters;
      parameters.radius = radius;
      parameters.axis   = axis;
      test(kind + " drum",
           std::make_shared<RigidDrum>(line(), parameters),
           [&](const Point<3> &x) {
             const Point<3> center = line().point + radius * across;
             const double rho = cross_product_3d(unit_axis, x - center).norm();
             return std::copysign(rho, radius) - radius;
           });
    }

  for (const double radius : {1e16, -1e16})
    {
      const std::string sign = (radius > 0 ? "" : "minus ");
      compare_with_plane("sphere of a radius of " + sign + "1e16",
                         RigidSphere(line(), radius));
      RigidDrum::Parameters parameters;
      parameters.radius = radius;
      parameters.axis   = cross_product_3d(direction, axis);
      compare_with_plane("drum of a radius of " + sign + "1e16",
                         RigidDrum(line(), parameters));
    }

  const Point<3> beside =
    line().point + 5 * cross_product_3d(direction, unit_axis);
  const double infinity = std::numeric_limits<double>::infinity();
  check_true("a small sphere passes by",
             RigidSphere(line(), 1.).travel_to(beside) == infinity);
  check_true("a point that is always inside",
             RigidSphere(line(), -1.).travel_to(beside) == -infinity);
}
