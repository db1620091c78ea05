// SPDX-License-Identifier: LGPL-2.1-or-later

// The clearance of each shape of a body is the distance from its surface, the
// normal is minus its gradient, and the derivative of the normal is minus its
// second derivative, inside and outside, at edges, arcs and flat parts; and the
// velocity of a body is the derivative of its motion.

#include <biface/contact/body_parameters.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  BodyParameters
  body(const BodyParameters::Shape shape)
  {
    BodyParameters result;
    result.name      = "some";
    result.shape     = shape;
    result.point     = Point<3>(3, -1, 2);
    result.axis      = Tensor<1, 3>({0, 2, 0});
    result.direction = Tensor<1, 3>({3, 0, 0});
    return result;
  }


  Point<3>
  some_point(const unsigned int i)
  {
    return Point<3>(3, -1, 2) + Tensor<1, 3>({4 * std::sin(1 + 3.1 * i),
                                              4 * std::sin(2 + 5.3 * i),
                                              4 * std::sin(3 + 7.9 * i)});
  }


  /** @param distance that from the surface, by the coordinates from the point:
   * across, up, and along the axis. */
  void
  test(const std::string    &name,
       const BodyParameters &parameters,
       const std::function<double(const double, const double, const double)>
         &distance)
  {
    const double    step = 1e-5;
    const RigidBody made = parameters.make();

    double       clearance = 0, unit = 0, normal = 0, gradient = 0;
    unsigned int n_inside = 0;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const Point<3>     x  = some_point(i);
        const Tensor<1, 3> y  = x - parameters.point;
        const BodyPoint    at = made.evaluate(x);
        n_inside += (at.clearance < 0);
        clearance = std::max(
          clearance, std::abs(at.clearance - distance(y[2], -y[0], y[1])));
        unit = std::max(unit, std::abs(at.normal.norm() - 1));
        Tensor<1, 3> minus_gradient;
        bool         smooth = true;
        Tensor<2, 3> differences;
        for (unsigned int j = 0; j < 3; ++j)
          {
            Tensor<1, 3> e;
            e[j]               = step;
            const auto forward = made.evaluate(x + e);
            const auto back    = made.evaluate(x - e);
            // between two parts of the surface
            smooth = smooth && (forward.normal - back.normal).norm() < 1e-3;
            minus_gradient[j] =
              (back.clearance - forward.clearance) / (2 * step);
            for (unsigned int k = 0; k < 3; ++k)
              differences[k][j] =
                (forward.normal[k] - back.normal[k]) / (2 * step);
          }
        if (!smooth)
          continue;
        normal   = std::max(normal, (minus_gradient - at.normal).norm());
        gradient = std::max(
          gradient, (differences - Tensor<2, 3>(at.normal_gradient)).norm());
      }
    std::cout << name << ": " << (n_inside > 0 && n_inside < 200) << ' '
              << (clearance < 1e-12) << ' ' << (unit < 1e-13) << ' '
              << (normal < 1e-8) << ' ' << (gradient < 1e-3) << std::endl;
  }
} // namespace


int
main()
{
  using Shape = BodyParameters::Shape;

  std::cout << "inside and outside, clearance, unit normal, normal and its "
               "derivative:"
            << std::endl;
  BodyParameters sphere = body(Shape::sphere);
  sphere.radius         = 2.5;
  test("sphere", sphere, [](double u, double v, double w) {
    return std::sqrt(u * u + v * v + w * w) - 2.5;
  });
  sphere.radius = -2.5;
  test("hollow sphere", sphere, [](double u, double v, double w) {
    return 2.5 - std::sqrt(u * u + v * v + w * w);
  });
  BodyParameters cylinder = body(Shape::cylinder);
  cylinder.radius         = 2.5;
  test("cylinder", cylinder, [](double u, double v, double) {
    return std::hypot(u, v) - 2.5;
  });
  BodyParameters torus = body(Shape::torus);
  torus.radius         = 3;
  torus.tube_radius    = 1.2;
  test("torus", torus, [](double u, double v, double w) {
    return std::hypot(std::hypot(u, v) - 3, w) - 1.2;
  });
  BodyParameters plane = body(Shape::plane);
  test("plane", plane, [](double, double v, double) { return v; });
  BodyParameters cone = body(Shape::cone);
  cone.half_angle     = 30;
  test("cone", cone, [](double u, double v, double w) {
    const double r = std::hypot(u, v), c = std::sqrt(0.75), s = 0.5;
    // beyond the normal at the tip, the distance from the tip
    return w * c < -r * s ? std::hypot(r, w) : r * c - w * s;
  });
  BodyParameters step = body(Shape::step);
  step.edge_radius    = 0;
  test("step", step, [](double u, double v, double) {
    return u < 0 && v > 0 ? std::hypot(u, v) : std::max(-u, v);
  });
  step.edge_radius = 0.8;
  test("rounded step", step, [](double u, double v, double) {
    return u < 0.8 && v > -0.8 ? std::hypot(u - 0.8, v + 0.8) - 0.8
                               : std::max(-u, v);
  });
  // a channel with a rounded inner corner on the right
  BodyParameters channel = body(Shape::extruded);
  channel.profile        = {
           {Point<2>(-9, 0)}, {Point<2>(1, 0), 0.7}, {Point<2>(1, 5)}};
  test("channel", channel, [](double u, double v, double) {
    return u > 0.3 && v < 0.7 ? 0.7 - std::hypot(u - 0.3, v - 0.7)
                              : std::min(v, 1 - u);
  });
  // a square ring, the polygon against the other direction, too
  BodyParameters ring = body(Shape::revolved);
  ring.profile        = {{Point<2>(-1, 2)},
                         {Point<2>(1, 2)},
                         {Point<2>(1, 4)},
                         {Point<2>(-1, 4)},
                         {Point<2>(-1, 2)}};
  const auto square   = [](double u, double v, double w) {
    const double r = std::abs(std::hypot(u, v) - 3) - 1, z = std::abs(w) - 1;
    return r > 0 && z > 0 ? std::hypot(r, z) : std::max(r, z);
  };
  test("ring", ring, square);
  std::reverse(ring.profile.begin(), ring.profile.end());
  test("reversed ring", ring, square);

  // points on the normals at the ends of lines, between two parts of the
  // surface, and the radius of the first corner given at either place
  double gap = 0;
  for (unsigned int i = 0; i < 200; ++i)
    {
      std::vector<RoundedPolygon::Corner> corners(4);
      for (unsigned int j = 0; j < 3; ++j)
        corners[j].point = Point<2>(20 * std::cos(2.1 * j + 0.1 * i),
                                    15 * std::sin(2.1 * j + i * 0.1));
      corners[3] = corners[0];
      const RoundedPolygon polygon(corners, "polygon");
      for (unsigned int j = 0; j < 3; ++j)
        {
          Tensor<1, 2> way = corners[j + 1].point - corners[j].point;
          way /= way.norm();
          // counterclockwise
          const Tensor<1, 2> out({way[1], -way[0]});
          for (const unsigned int end : {j, j + 1})
            gap = std::max(
              gap,
              std::abs(
                polygon.evaluate(corners[end].point + (1 + 0.1 * i) * out)
                  .distance -
                (1 + 0.1 * i)));
        }
    }
  std::cout << "no gaps: " << (gap < 1e-12) << std::endl;
  double radius = 0;
  for (const unsigned int rounded : {0, 3})
    {
      std::vector<RoundedPolygon::Corner> corners{{Point<2>(0, 0)},
                                                  {Point<2>(3, -1)},
                                                  {Point<2>(-3, -1)},
                                                  {Point<2>(0, 0)}};
      corners[rounded].radius = 0.5;
      // the bisector of the corner
      const double half = std::atan2(3, 1);
      radius            = std::max(
        radius,
        std::abs(
          RoundedPolygon(corners, "polygon").evaluate(Point<2>(0, 1)).distance -
          (1 + 0.5 / std::sin(half) - 0.5)));
    }
  std::cout << "corner where a polygon closes: " << (radius < 1e-12)
            << std::endl;

  // two motions about one axis, and a displacement of both
  const Tensor<1, 3> axis({0, 1, 0});
  BodyMotion         first, second;
  first.translation    = Tensor<1, 3>({1, 2, -1});
  first.turn           = 0.7;
  first.factor         = 1;
  second.translation   = Tensor<1, 3>({0, -1, 3});
  second.turn          = -1.1;
  second.factor        = 2;
  const RigidBody rest = cylinder.make();
  const auto      at   = [&](const double a, const double b) {
    return rest
      .after_motions(
        {first, second},
        [&](const unsigned int i) { return i == 1 ? a : b; },
        axis,
        Point<3>(1, 2, 3))
      .displaced(
        Tensor<1, 3>({0, 1, 1}), 0.3, Point<3>(), Tensor<1, 3>({1, 0, 0}));
  };
  const Point<3> of_body(0.4, -2, 1);
  const auto     body_now = at(0.3, 0.6);
  const double   h        = 1e-6;
  const auto     velocity =
    body_now.velocity(body_now.present(of_body), 0, [](const unsigned int i) {
      return i == 1 ? 2. : 5.;
    });
  const auto difference = (at(0.3 + 2 * h, 0.6 + 5 * h).present(of_body) -
                           at(0.3 - 2 * h, 0.6 - 5 * h).present(of_body)) /
                          (2 * h);
  std::cout << "velocity: " << ((velocity - difference).norm() < 1e-7)
            << std::endl;
}
