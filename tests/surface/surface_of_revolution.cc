// SPDX-License-Identifier: LGPL-2.1-or-later

// Frames, Lamé parameters, curvatures and connection of a surface of revolution
// agree with finite differences of its positions and frames.

#include <deal.II/base/numbers.h>

#include <biface/surface/circular_arc.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/surface_of_revolution.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** An ellipse, run through with a varying speed. */
  class Ellipse : public Meridian
  {
  public:
    PointOfCurve
    evaluate(const double s) const override
    {
      return {Point<2>(70 + 30 * std::cos(s), 50 * std::sin(s)),
              Tensor<1, 2>({-30 * std::sin(s), 50 * std::cos(s)}),
              Tensor<1, 2>({-30 * std::cos(s), -50 * std::sin(s)})};
    }

    double
    parameter_of(const Point<2> &point) const override
    {
      return std::atan2(point[1] / 50, (point[0] - 70) / 30);
    }

    std::pair<double, double>
    range() const override
    {
      return {-numbers::PI, numbers::PI};
    }

    double
    coordinate_unit() const override
    {
      return 1;
    }
  };


  /** The largest deviations found, each as a fraction of its scale. */
  struct Deviations
  {
    double frame = 0, lame = 0, curvature = 0, geodesic = 0, connection = 0,
           gradient = 0, inverse = 0;
  };


  void
  record(double &largest, const double deviation)
  {
    // unlike std::max, this keeps what is not a number
    if (!(std::abs(deviation) <= largest))
      largest = std::abs(deviation);
  }


  void
  compare(const ReferenceSurface &surface,
          const Point<2>         &alpha,
          Deviations             &deviations)
  {
    const double       step   = 1e-5;
    const double       length = 50;
    const SurfacePoint point  = surface.evaluate(alpha);
    const auto        &e      = point.frame;

    record(deviations.frame, (cross_product_3d(e[0], e[1]) - e[2]).norm());
    record(deviations.inverse,
           (surface.pull_back(point.position) - alpha).norm());

    for (unsigned int a = 0; a < 2; ++a)
      {
        Point<2> forward = alpha, backward = alpha;
        forward[a] += step;
        backward[a] -= step;
        const SurfacePoint f = surface.evaluate(forward);
        const SurfacePoint b = surface.evaluate(backward);

        const Tensor<1, 3> tangent = (f.position - b.position) / (2 * step);
        record(deviations.frame, (tangent / tangent.norm() - e[a]).norm());
        record(deviations.lame, (point.lame[a] - tangent.norm()) / length);
        Tensor<1, 3> gradient;
        for (unsigned int i = 0; i < 3; ++i)
          gradient[i] = surface.push_forward_gradient(alpha)[i][a];
        record(deviations.gradient, (gradient - tangent).norm() / length);

        // the normal turns outward where the surface curves inward
        const Tensor<1, 3> turn =
          (f.frame[2] - b.frame[2]) / (2 * step * point.lame[a]);
        record(deviations.curvature,
               (turn - point.curvature[a] * e[a]).norm() * length);
        // a constant field changes its components, not itself
        const Tensor<1, 3> x({0.3, -0.8, 0.5});
        const Tensor<1, 3> change =
          (f.to_frame(x) - b.to_frame(x)) / (2 * step * point.lame[a]);
        record(deviations.connection,
               (change + point.connection(a) * point.to_frame(x)).norm() *
                 length);

        // B_a = A_{c,a} / (A_1 A_2)
        const double stretch = (f.lame[1 - a] - b.lame[1 - a]) / (2 * step);
        record(deviations.geodesic,
               (point.geodesic[a] - stretch / (point.lame[0] * point.lame[1])) *
                 length);
      }
  }


  void
  test(const std::string &name, std::shared_ptr<const Meridian> meridian)
  {
    const SurfaceOfRevolution surface(meridian);
    Deviations                d;
    for (const double alpha_1 : {-2., -0.7, 0., 0.4, 1.9})
      for (const double alpha_2 : {-3., -1., 0., 2.})
        compare(surface, Point<2>(alpha_1, alpha_2), d);

    std::cout << name << std::endl;
    check_small("  frame", d.frame, 1e-8);
    check_small("  Lame parameters", d.lame, 1e-8);
    check_small("  tangents", d.gradient, 1e-8);
    check_small("  curvatures", d.curvature, 1e-8);
    check_small("  geodesic curvatures", d.geodesic, 1e-8);
    check_small("  connection", d.connection, 1e-8);
    check_small("  coordinates of a position", d.inverse, 1e-12);
  }
} // namespace


int
main()
{
  test("torus", std::make_shared<CircularArc>(CircularArc::Parameters()));
  CircularArc::Parameters sphere;
  sphere.center_radius = 0;
  const SurfaceOfRevolution surface(std::make_shared<CircularArc>(sphere));
  test("ellipse", std::make_shared<Ellipse>());

  // outward is away from the center of the arc
  const SurfacePoint point = surface.evaluate(Point<2>(0.3, 1.1));
  check_small("the normal of a sphere of radius 50 is radial",
              (point.frame[2] - point.position / 50).norm(),
              1e-14);
  check_small("its curvatures are 1/50",
              std::abs(50 * point.curvature[0] - 1) +
                std::abs(50 * point.curvature[1] - 1),
              1e-14);
}
