// SPDX-License-Identifier: LGPL-2.1-or-later

// Ground that slides and turns, and goes around the axle of a wheel,
// carries its points along: a point that moves with it keeps its clearance, its
// normal and tangents turn with it, and the derivatives of clearance and normal
// are those of differences.

#include <deal.II/physics/transformations.h>

#include <biface/contact/ground_parameters.h>
#include <biface/contact/rigid_body.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string                      &name,
       const std::shared_ptr<const BodyShape> &shape,
       const double                            around)
  {
    using Physics::Transformations::Rotations::rotation_matrix_3d;

    const double       turn = 0.4, step = 1e-5;
    const Tensor<1, 3> d     = shape->direction;
    const Tensor<1, 3> slide = cross_product_3d(d, Tensor<1, 3>({1, 2, 3}));
    const Point<3>     pivot(1, 0.5, -0.3);
    const Tensor<1, 3> axle({0., 1., 0.});
    const Tensor<2, 3> R_y    = rotation_matrix_3d(Point<3>(0, 1, 0), around);
    const Tensor<2, 3> R_d    = rotation_matrix_3d(Point<3>(d), turn);
    const Tensor<2, 3> R      = R_y * R_d;
    const RigidBody    before = RigidBody(shape).moved(0.3);
    const RigidBody    after =
      before.displaced(slide, turn, pivot).rotated(axle, around);

    std::cout << name << (around == 0 ? "" : ", around the axle") << std::endl;
    double carried = 0, clearance = 0, normal = 0, tangents = 0, unit = 0,
           travel = 0, gradient = 0;
    for (unsigned int i = 0; i < 10; ++i)
      {
        const Point<3> x(3 + std::sin(1 + 3.1 * i),
                         std::sin(2 + 5.3 * i),
                         std::sin(3 + 7.9 * i));
        const Point<3> y(R_y * (pivot + slide + R_d * (x - pivot)));
        carried = std::max({carried,
                            after.present(before.at_rest(x)).distance(y),
                            after.at_rest(y).distance(before.at_rest(x))});

        const BodyPoint at = before.evaluate(x), there = after.evaluate(y);
        clearance =
          std::max(clearance, std::abs(at.clearance - there.clearance));
        normal       = std::max(normal, (R * at.normal - there.normal).norm());
        const auto t = before.tangents(at.normal);
        const auto s = after.tangents(there.normal);
        for (unsigned int a = 0; a < 2; ++a)
          {
            tangents = std::max(tangents, (R * t[a] - s[a]).norm());
            unit     = std::max(
              {unit, std::abs(s[a] * s[a] - 1), std::abs(s[a] * there.normal)});
          }
        unit = std::max(unit, std::abs(s[0] * s[1]));
        travel =
          std::max(travel, std::abs(after.travel_to(y) - before.travel_to(x)));
        for (unsigned int j = 0; j < 3; ++j)
          {
            Tensor<1, 3> e;
            e[j]                 = step;
            const auto   forward = after.evaluate(y + e);
            const auto   back    = after.evaluate(y - e);
            Tensor<1, 3> column;
            for (unsigned int k = 0; k < 3; ++k)
              column[k] = there.normal_gradient[k][j];
            gradient = std::max(
              {gradient,
               ((forward.normal - back.normal) / (2 * step) - column).norm(),
               std::abs((forward.clearance - back.clearance) / (2 * step) +
                        there.normal[j])});
          }
      }
    check_small("  direction", (after.direction() - R * d).norm(), 1e-14);
    check_small("  points that move with it", carried, 1e-14);
    check_small("  their clearance", clearance, 1e-14);
    check_small("  normal", normal, 1e-14);
    check_small("  tangents", tangents, 1e-14);
    check_small("  unit vectors at right angles", unit, 1e-14);
    check_small("  travel to a point", travel, 1e-14);
    check_small("  derivatives", gradient, 1e-9);
  }
} // namespace


int
main()
{
  const BodyShape::TravelLine line{Tensor<1, 3>({2, 0.6, -0.4}),
                                   Point<3>(3, -1, 2)};
  RigidDrum::Parameters       parameters;
  parameters.radius = 5;
  parameters.axis   = Tensor<1, 3>({0.2, 0.8, 0.6});
  const auto plane  = std::make_shared<RigidPlane>(line);
  const auto sphere = std::make_shared<RigidSphere>(line, 4.);
  const auto drum   = std::make_shared<RigidDrum>(line, parameters);
  for (const double around : {0., 2.})
    {
      test("plane", plane, around);
      test("sphere", sphere, around);
      test("drum", drum, around);
    }
}
