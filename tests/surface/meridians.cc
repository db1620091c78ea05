// SPDX-License-Identifier: LGPL-2.1-or-later

// A spline through points of a circle converges to it away from its ends, with
// fourth order in position and second order in curvature; a straight line is
// reproduced; and for both the parameter of a point is the inverse of the
// curve.

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
}
