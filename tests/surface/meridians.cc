// SPDX-License-Identifier: LGPL-2.1-or-later

// A spline through points of a circle converges to it away from its ends, with
// fourth order in position and second order in curvature; a straight line is
// reproduced; and for both the parameter of a point is the inverse of the
// curve. Points that are almost repeated do not change the curve, at any gap
// and in any unit; close points on a smooth curve remain. A corner has the
// given radius, is smooth at its ends, and leaves straight parts straight.

#include <vector>

#include <biface/surface/spline_curve.h>
#include <biface/surface/straight_line.h>
#include <biface/surface/surface_of_revolution.h>

#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** Points of an arc of radius 50 about (200, 0), from -120 to 120 degrees. */
  SplineCurve
  spline_of_arc(const unsigned int n)
  {
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double psi = (-120 + 240. * i / n) * numbers::PI / 180;
        points.emplace_back(200 + 50 * std::cos(psi), 50 * std::sin(psi));
      }
    return SplineCurve(points, "arc");
  }


  /** Maximum deviations of position and curvature k_1 from the circle, in the
   * middle half of the curve. */
  std::pair<double, double>
  deviations(const unsigned int n)
  {
    const auto spline = std::make_shared<SplineCurve>(spline_of_arc(n));
    const SurfaceOfRevolution surface(spline);
    double                    position = 0, curvature = 0;
    for (unsigned int i = 0; i <= 1000; ++i)
      {
        const double s = spline->length() * (0.25 + 0.0005 * i);
        position       = std::max(
          position,
          std::abs(spline->evaluate(s).position.distance(Point<2>(200, 0)) -
                   50));
        curvature = std::max(
          curvature,
          std::abs(50 * surface.evaluate(Point<2>(s, 0.3)).curvature[0] - 1));
      }
    return {position, curvature};
  }


  double
  inverse_error(const Meridian &meridian)
  {
    double error = 0;
    for (unsigned int i = 0; i <= 100; ++i)
      {
        const double s =
          meridian.range().first +
          0.01 * i * (meridian.range().second - meridian.range().first);
        error = std::max(
          error,
          std::abs(meridian.parameter_of(meridian.evaluate(s).position) - s));
      }
    return error / meridian.range().second;
  }


  /** Points of a contour of 80 mm, in units of @p unit millimeters. */
  std::vector<Point<2>>
  contour(const double unit)
  {
    std::vector<Point<2>> points;
    for (const auto &[r, y] : std::vector<std::pair<double, double>>{
           {60, 0}, {66, 20}, {60, 40}, {50, 60}, {46, 80}})
      points.emplace_back(r / unit, y / unit);
    return points;
  }


  /** The largest distance of two curves with the same range. */
  double
  distance(const Meridian &a, const Meridian &b)
  {
    double distance = 0;
    for (unsigned int i = 0; i <= 100; ++i)
      {
        const double s = 0.01 * i * a.range().second;
        distance       = std::max(
          distance, a.evaluate(s).position.distance(b.evaluate(s).position));
      }
    return distance;
  }


  void
  almost_repeated_points()
  {
    double       largest = 0;
    unsigned int remarks = 0, curves = 0;
    for (const double unit : {1., 1000., 1e-3})
      for (const double gap : {0., 1e-7, 1e-3, 0.1, 0.5})
        // beside each inner point, in directions in which the curve turns back,
        // and at the end of it
        for (const double direction : {0., 200., 340.})
          for (const unsigned int i : {1, 2, 3, 4})
            {
              std::vector<Point<2>> points = contour(unit);
              const double          psi    = direction * numbers::PI / 180;
              points.insert(points.begin() + i + (i < 4 ? 1 : 0),
                            points[i] +
                              gap / unit *
                                Tensor<1, 2>({std::cos(psi), std::sin(psi)}));
              const SplineCurve curve(points, "contour");
              largest = std::max(
                largest,
                unit * distance(curve, SplineCurve(contour(unit), "contour")));
              remarks += curve.get_remarks().size();
              ++curves;
            }
    check_small("distance by points almost repeated", largest, 1e-12, 80);
    check_true("a remark on each of them", remarks == curves);

    // an arc with pairs of points as close as 1e-3 of the others
    std::vector<Point<2>> arc;
    for (unsigned int i = 0; i <= 48; ++i)
      for (const double beside : {-0.5e-3, 0.5e-3})
        {
          const double psi = (-120 + 5. * (i + beside)) * numbers::PI / 180;
          arc.emplace_back(200 + 50 * std::cos(psi), 50 * std::sin(psi));
        }
    const SplineCurve curve(arc, "arc");
    check_true("no remark on pairs on an arc", curve.get_remarks().empty());
    double position = 0;
    for (unsigned int i = 0; i <= 1000; ++i)
      position =
        std::max(position,
                 std::abs(curve.evaluate(curve.length() * (0.25 + 0.0005 * i))
                            .position.distance(Point<2>(200, 0)) -
                          50));
    check_small("position with pairs of points", position, 1e-5, 50);
  }


  void
  noisy_pair()
  {
    // 5 mm apart, and a pair 0.02 mm apart that is off the line by a micrometer
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= 10; ++i)
      points.emplace_back(100, 5 * i);
    std::vector<Point<2>> noisy = points;
    noisy.insert(noisy.begin() + 5, Point<2>(100.001, 19.98));
    noisy[4][0] = 100;
    const SplineCurve curve(noisy, "noisy");
    check_small("distance by a noisy pair",
                distance(curve, SplineCurve(points, "line")),
                2e-3,
                1);
    check_true("a remark on it", curve.get_remarks().size() == 1);
  }


  void
  neighboring_kinks()
  {
    // a cylinder, a cone and a cylinder by their corners alone
    const std::vector<Point<2>> points{
      {100, 0}, {100, 40}, {80, 60}, {80, 100}};
    const SplineCurve curve(points, "corners", 5);
    double            off = 0;
    for (unsigned int i = 0; i <= 1000; ++i)
      {
        const Point<2> x =
          curve.evaluate(0.001 * i * curve.range().second).position;
        const double from_cone = std::abs(x[0] + x[1] - 140) / std::sqrt(2.);
        off                    = std::max(
          off,
          std::min({std::abs(x[0] - 100), std::abs(x[0] - 80), from_cone}));
      }
    check_true("both corners are rounded", off > 0.1 && off < 0.45);
    // a regular polygon of 18 corners is a coarse circle, and has none
    std::vector<Point<2>> circle;
    for (unsigned int i = 0; i <= 12; ++i)
      {
        const double psi = (-120 + 20. * i) * numbers::PI / 180;
        circle.emplace_back(200 + 50 * std::cos(psi), 50 * std::sin(psi));
      }
    const SplineCurve smooth(circle, "circle", 5);
    check_true("a Corner radius without kinks is named",
               smooth.get_remarks().size() == 1);
  }


  void
  corners()
  {
    // a cylinder and a cone of 45 degrees
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i < 5; ++i)
      points.emplace_back(100, 25 * i);
    for (unsigned int i = 1; i < 4; ++i)
      points.emplace_back(100 - 20 * i, 100 + 20 * i);
    const SplineCurve smooth(points, "kink"), sharp(points, "kink", 10);
    double            swing = 0, off = 0, jump = 0, curvature = 0;
    const double      half = 22.5 * numbers::PI / 180;
    // where the rounding begins and ends
    const double length =
      1.5 * 10 * std::sin(half) / (std::cos(half) * std::cos(half));
    for (unsigned int i = 0; i <= 1000; ++i)
      {
        const double s = 0.001 * i * (100 - length);
        swing = std::max(swing, std::abs(smooth.evaluate(s).position[0] - 100));
        off   = std::max(off, std::abs(sharp.evaluate(s).position[0] - 100));
        const auto at = sharp.evaluate(100 - length + 0.002 * i * length);
        const Tensor<1, 2> d = at.first_derivative, dd = at.second_derivative;
        curvature = std::max(curvature,
                             std::abs(d[0] * dd[1] - d[1] * dd[0]) /
                               std::pow(d.norm(), 3));
      }
    for (const double end : {100 - length, 100 + length})
      {
        const auto a = sharp.evaluate(end - 1e-9),
                   b = sharp.evaluate(end + 1e-9);
        jump         = std::max({jump,
                                 a.position.distance(b.position),
                                 (a.first_derivative - b.first_derivative).norm(),
                                 (a.second_derivative - b.second_derivative).norm()});
      }
    check_range("swing beside a kink", swing, 0.5, 1.5);
    check_small("swing beside a corner", off, 1e-12, 100);
    check_small("least radius of a corner", 10 * curvature - 1, 1e-5);
    check_small("jumps at the ends of a corner", jump, 1e-7);
    check_small("parameter on a corner", inverse_error(sharp), 1e-12);
    check_true("a remark on a kink", smooth.get_remarks().size() == 1);
    check_true("a remark on a corner", sharp.get_remarks().size() == 1);
    check_true("no remark on an arc of few points",
               spline_of_arc(12).get_remarks().empty());
  }
} // namespace


int
main()
{
  const auto coarse = deviations(24);
  const auto fine   = deviations(48);
  check_range(
    "order of the position", std::log2(coarse.first / fine.first), 3.8, 4.5);
  check_range(
    "order of the curvature", std::log2(coarse.second / fine.second), 1.8, 2.2);
  check_small("position", fine.first, 1e-5, 50);
  check_small("curvature", fine.second, 1e-3);
  check_small(
    "parameter on the spline", inverse_error(spline_of_arc(24)), 1e-12);

  StraightLine::Parameters parameters;
  parameters.start = Point<2>(3, 1);
  parameters.end   = Point<2>(6, 5);
  const auto line  = std::make_shared<StraightLine>(parameters);
  check_small("parameter on the line", inverse_error(*line), 1e-14);
  check_small("length of the line", line->range().second - 5, 1e-14);

  // a cone of this slope: k_2 = sin(angle from the plane) / r
  const SurfaceOfRevolution cone(line);
  const SurfacePoint        point = cone.evaluate(Point<2>(2.5, 1));
  check_small("curvatures of a cone",
              std::hypot(point.curvature[0], point.curvature[1] - 0.8 / 4.5),
              1e-14);

  almost_repeated_points();
  corners();
  noisy_pair();
  neighboring_kinks();
}
