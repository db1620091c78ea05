// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/spline_curve.h>

namespace Biface
{
  using namespace dealii;

  SplineCurve::SplineCurve(const std::vector<Point<2>> &points,
                           const std::string           &name)
  {
    if (points.size() < 3)
      throw InputError(name + ": the curve has " +
                       std::to_string(points.size()) +
                       " points, but a spline needs at least 3.");

    // for each node, the foot of a perpendicular is sought among all points
    constexpr unsigned int max_points = 10000;
    if (points.size() > max_points)
      throw InputError(name + ": the curve has " +
                       std::to_string(points.size()) + " points, but at most " +
                       std::to_string(max_points) + " are allowed.");

    std::vector<double> r, y;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const std::string where = name + ": the point " +
                                  std::to_string(i + 1) + " of the curve, (" +
                                  number_to_string(points[i][0]) + ", " +
                                  number_to_string(points[i][1]) + "), ";
        if (!(std::isfinite(points[i][0]) && std::isfinite(points[i][1])))
          throw InputError(where + "must be finite.");
        if (!(points[i][0] > 0))
          throw InputError(where +
                           "must have a positive radius, since a meridian "
                           "must not meet the axis.");
        const double step = (i == 0 ? 0. : points[i].distance(points[i - 1]));
        const double way  = (i == 0 ? 0. : knots.back() + step);
        // their distance must not be lost in the round-off of the length so far
        if (i > 0 && !(way > knots.back()))
          throw InputError(where + "must differ from the previous one.");
        knots.push_back(way);
        r.push_back(points[i][0]);
        y.push_back(points[i][1]);
      }
    radius = std::make_unique<Functions::CSpline<1>>(knots, r);
    axial  = std::make_unique<Functions::CSpline<1>>(knots, y);

    constexpr unsigned int n_samples = 4;
    for (unsigned int i = 0; i + 1 < knots.size(); ++i)
      for (unsigned int k = 0; k <= n_samples; ++k)
        {
          const double s = knots[i] + (knots[i + 1] - knots[i]) * k / n_samples;
          samples.emplace_back(s, evaluate(s).position);
        }
  }


  Meridian::PointOfCurve
  SplineCurve::evaluate(const double s) const
  {
    // the end points, up to round-off
    const Point<1> knot(std::min(std::max(s, knots.front()), knots.back()));
    return {
      Point<2>(radius->value(knot), axial->value(knot)),
      Tensor<1, 2>({radius->gradient(knot)[0], axial->gradient(knot)[0]}),
      Tensor<1, 2>({radius->hessian(knot)[0][0], axial->hessian(knot)[0][0]})};
  }


  double
  SplineCurve::parameter_of(const Point<2> &point) const
  {
    // the nearest of the samples, then Newton's method for the foot of the
    // perpendicular
    double best = std::min_element(samples.begin(),
                                   samples.end(),
                                   [&](const auto &a, const auto &b) {
                                     return a.second.distance_square(point) <
                                            b.second.distance_square(point);
                                   })
                    ->first;
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        const PointOfCurve curve  = evaluate(best);
        const Tensor<1, 2> offset = curve.position - point;
        const double slope = curve.first_derivative * curve.first_derivative +
                             offset * curve.second_derivative;
        const double update = -(offset * curve.first_derivative) / slope;
        best                = std::min(std::max(best + update, 0.), length());
        if (std::abs(update) < 1e-14 * length())
          break;
      }
    return best;
  }


  std::pair<double, double>
  SplineCurve::range() const
  {
    return {0, length()};
  }


  double
  SplineCurve::coordinate_unit() const
  {
    return 1;
  }
} // namespace Biface
