// SPDX-License-Identifier: LGPL-2.1-or-later

// A body given by a formula is the body of that shape, a closest point of an
// ellipsoid is found from far and near, a height field converges with the
// fourth order of its spacing, and clearance, normal and derivative of the
// normal are consistent; in mm as in m.

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <biface/contact/body_parameters.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  using Shape = BodyParameters::Shape;

  BodyParameters
  body(const Shape shape)
  {
    BodyParameters result;
    result.name      = "some";
    result.shape     = shape;
    result.point     = Point<3>(3, -1, 2);
    result.axis      = Tensor<1, 3>({0, 2, 0});
    result.direction = Tensor<1, 3>({0, 0, -3});
    return result;
  }


  RigidBody
  by_formula(const std::string &formula, const double size)
  {
    BodyParameters result = body(Shape::formula);
    result.formula        = formula;
    result.size           = size;
    return result.make();
  }


  Point<3>
  some_point(const unsigned int i, const double distance)
  {
    return Point<3>(3, -1, 2) +
           distance * Tensor<1, 3>({std::sin(1 + 3.1 * i),
                                    std::sin(2 + 5.3 * i),
                                    std::sin(3 + 7.9 * i)});
  }


  /** The largest differences of clearance, normal, and its derivative. */
  void
  compare(const std::string &name,
          const RigidBody   &body,
          const RigidBody   &other,
          const double       unit = 1)
  {
    double       clearance = 0, normal = 0, gradient = 0;
    unsigned int n_inside = 0;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const Point<3> x = some_point(i, i % 10 == 0 ? 500 : 4);
        const Point<3> y = Point<3>(3, -1, 2) + unit * (x - Point<3>(3, -1, 2));
        const BodyPoint a = body.evaluate(y), b = other.evaluate(x);
        n_inside += (b.clearance < 0);
        clearance =
          std::max(clearance, std::abs(a.clearance / unit - b.clearance));
        normal   = std::max(normal, (a.normal - b.normal).norm());
        gradient = std::max(
          gradient, (unit * a.normal_gradient - b.normal_gradient).norm());
      }
    std::cout << name << ": " << (n_inside > 0 && n_inside < 200) << ' '
              << (clearance < 1e-8) << ' ' << (normal < 1e-8) << ' '
              << (gradient < 1e-8) << std::endl;
  }


  /** How far the clearance of waves exceeds the distance of one of their
   * points, at most, and falls below the least of these distances. */
  std::array<double, 2>
  compare_with_all_points(const RigidBody &waves)
  {
    double above = 0, below = 0;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const Point<3> x     = some_point(i, 3);
        double         least = std::numeric_limits<double>::infinity();
        for (double u = -8; u < 8; u += 0.03)
          for (double v = -8; v < 8; v += 0.03)
            least =
              std::min(least,
                       x.distance(Point<3>(
                         3 + u, -1 + v, 2 + 0.3 * std::cos(u) * std::cos(v))));
        const double c = std::abs(waves.evaluate(x).clearance);
        above          = std::max(above, c - least);
        below          = std::max(below, least - c);
      }
    return {{above, below}};
  }


  /** The normal and its derivative against differences of the clearance. */
  void
  check_derivatives(const std::string &name,
                    const RigidBody   &body,
                    const double       distance,
                    const double       step)
  {
    double       unit = 0, normal = 0, gradient = 0;
    unsigned int n_smooth = 0;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const Point<3>  x  = some_point(i, distance);
        const BodyPoint at = body.evaluate(x);
        unit               = std::max(unit, std::abs(at.normal.norm() - 1));
        Tensor<1, 3> minus_gradient;
        Tensor<2, 3> differences;
        bool         smooth = (at.normal_gradient.norm() < 2);
        for (unsigned int j = 0; j < 3; ++j)
          {
            Tensor<1, 3> e;
            e[j] = step;
            // of fourth order
            const std::array<double, 4> factors{
              {1. / 12, -8. / 12, 8. / 12, -1. / 12}};
            const std::array<double, 4> places{{-2, -1, 1, 2}};
            for (unsigned int q = 0; q < 4; ++q)
              {
                const auto there = body.evaluate(x + places[q] * e);
                // between the regions of two closest points
                smooth = smooth && (there.normal - at.normal).norm() < 0.1;
                minus_gradient[j] -= factors[q] * there.clearance / step;
                for (unsigned int k = 0; k < 3; ++k)
                  differences[k][j] += factors[q] * there.normal[k] / step;
              }
          }
        if (!smooth)
          continue;
        ++n_smooth;
        normal   = std::max(normal, (minus_gradient - at.normal).norm());
        gradient = std::max(
          gradient,
          distance * (differences - Tensor<2, 3>(at.normal_gradient)).norm());
      }
    std::cout << name << ": " << (n_smooth > 100) << ' ' << (unit < 1e-13)
              << ' ' << (normal < 1e-6) << ' ' << (gradient < 1e-6)
              << std::endl;
  }


  /** The largest errors of clearance and normal at points on the normals of a
   * surface.
   * @param on_surface gives a point and its unit normal outward. */
  std::array<double, 2>
  errors_along_normals(
    const RigidBody &body,
    const std::function<std::pair<Point<3>, Tensor<1, 3>>(const unsigned int)>
                              &on_surface,
    const std::vector<double> &distances)
  {
    double clearance = 0, normal = 0;
    for (unsigned int i = 0; i < 100; ++i)
      for (const double distance : distances)
        {
          const auto [y, n]  = on_surface(i);
          const BodyPoint at = body.evaluate(y + distance * n);
          clearance = std::max(clearance, std::abs(at.clearance - distance));
          normal    = std::max(normal, (at.normal + n).norm());
        }
    return {{clearance, normal}};
  }


  /** A road that is level at both ends of its grid, as a height field. */
  BodyParameters
  wavy_field(const unsigned int n, const double unit = 1)
  {
    BodyParameters result = body(Shape::height_field);
    result.height_file    = "road.csv";
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= n; ++j)
        {
          // not uniform along v
          const double s = 1. * j / n;
          const double u = numbers::PI * (2. * i / n - 1),
                       v = numbers::PI *
                           (s + 0.1 * std::sin(2 * numbers::PI * s));
          result.heights.emplace_back(
            unit * u, unit * v, unit * 0.3 * std::cos(u) * std::cos(v));
        }
    return result;
  }


  std::pair<Point<3>, Tensor<1, 3>>
  on_wavy_road(const unsigned int i)
  {
    const double u = numbers::PI * std::sin(1 + 3.1 * i),
                 v = numbers::PI / 2 * (1 + std::sin(2 + 5.3 * i));
    // u is along x, as the direction is -z
    Tensor<1, 3> n(
      {0.3 * std::sin(u) * std::cos(v), 0.3 * std::cos(u) * std::sin(v), 1});
    const Tensor<1, 3> across =
      cross_product_3d(Tensor<1, 3>({0, 0, -1}), Tensor<1, 3>({0, 1, 0}));
    n[0] *= across[0];
    return {
      Point<3>(3 + across[0] * u, -1 + v, 2 + 0.3 * std::cos(u) * std::cos(v)),
      n / n.norm()};
  }
} // namespace


int
main()
{
  std::cout << "inside and outside, clearance, normal, its derivative:"
            << std::endl;
  BodyParameters sphere = body(Shape::sphere);
  sphere.radius         = 2.5;
  compare("sphere", by_formula("x^2 + y^2 + z^2 - 2.5^2", 2.5), sphere.make());
  compare("sphere by root",
          by_formula("sqrt(x^2 + y^2 + z^2) - 2.5", 1),
          sphere.make());
  compare("sphere in m",
          by_formula("x^2 + y^2 + z^2 - 0.0025^2", 0.0025),
          sphere.make(),
          1e-3);
  sphere.radius = -2.5;
  compare(
    "hollow sphere", by_formula("2.5^2 - x^2 - y^2 - z^2", 2.5), sphere.make());
  BodyParameters cylinder = body(Shape::cylinder);
  cylinder.radius         = 2.5;
  compare("cylinder", by_formula("x^2 + z^2 - 2.5^2", 2.5), cylinder.make());
  BodyParameters torus = body(Shape::torus);
  torus.radius         = 3;
  torus.tube_radius    = 1.2;
  compare("torus",
          by_formula("(sqrt(x^2 + z^2) - 3)^2 + y^2 - 1.2^2", 1),
          torus.make());
  compare("plane", by_formula("5*z", 1), body(Shape::plane).make());
  BodyParameters flat = body(Shape::height_field);
  flat.height_file    = "flat.csv";
  for (const double u : {-1, 2, 3})
    for (const double v : {-1, 1})
      flat.heights.emplace_back(u, v, 0);
  compare("flat field", flat.make(), body(Shape::plane).make());

  const auto of_ellipsoid = errors_along_normals(
    by_formula("(x/4)^2 + (y/3)^2 + (z/2)^2 - 1", 1),
    [](const unsigned int i) {
      Tensor<1, 3> e = some_point(i, 1) - some_point(i, 0);
      e /= e.norm();
      const Tensor<1, 3> n({e[0] / 4, e[1] / 3, e[2] / 2});
      return std::make_pair(Point<3>(3 + 4 * e[0], -1 + 3 * e[1], 2 + 2 * e[2]),
                            n / n.norm());
    },
    // the smallest radius of curvature is 1
    {-0.9, -0.1, 0, 1, 100});
  std::cout << "points on the normals of an ellipsoid: "
            << (of_ellipsoid[0] < 1e-8) << ' ' << (of_ellipsoid[1] < 1e-8)
            << std::endl;

  // within the smallest radius of curvature
  std::cout << "order of clearance and normal of a height field:" << std::endl;
  std::array<double, 2> last;
  for (const unsigned int n : {10, 20, 40, 80})
    {
      const auto errors = errors_along_normals(
        wavy_field(n).make(), on_wavy_road, {-1, -0.5, 0, 0.2, 1});
      if (n > 10)
        std::cout << (last[0] > 14 * errors[0]) << ' '
                  << (last[1] > 7 * errors[1]) << std::endl;
      last = errors;
    }

  const RigidBody waves  = by_formula("z - 0.3*cos(x)*cos(y)", 1);
  const auto      excess = compare_with_all_points(waves);
  std::cout << "the closest of all points: " << (excess[0] < 1e-12) << ' '
            << (excess[1] < 0.03) << std::endl;

  // a ramp from 0 to 1
  BodyParameters ramp       = body(Shape::height_field);
  ramp.height_file          = "ramp.csv";
  ramp.heights              = {{2, 1, 1}, {0, 1, 0}, {2, -1, 1}, {0, -1, 0}};
  const Tensor<1, 3> across = cross_product_3d(ramp.direction, ramp.axis) / 6;
  const auto         over_ramp = [&](const double u) {
    return ramp.make()
      .evaluate(ramp.point + u * across + Tensor<1, 3>({0, 7, 1.5}))
      .clearance;
  };
  std::cout << "beyond a grid: " << (std::abs(over_ramp(-9) - 1.5) < 1e-12)
            << ' ' << (std::abs(over_ramp(12) - 0.5) < 1e-12) << std::endl;

  std::cout << "points, unit normal, normal, its derivative:" << std::endl;
  check_derivatives(
    "ellipsoid", by_formula("(x/4)^2 + (y/3)^2 + (z/2)^2 - 1", 1), 6, 2e-4);
  check_derivatives("waves", by_formula("z - 0.3*cos(x)*cos(y)", 1), 4, 2e-4);
  // the third derivatives of a spline jump
  check_derivatives("height field", wavy_field(20).make(), 4, 2e-6);
}
