// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/spline_curve.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Polygon = std::vector<Point<2>>;

    /** Whether two segments cross, other than in an end. */
    bool
    cross(const Point<2> &a,
          const Point<2> &b,
          const Point<2> &c,
          const Point<2> &d)
    {
      const auto side =
        [](const Point<2> &from, const Point<2> &to, const Point<2> &of) {
          const Tensor<1, 2> line = to - from, way = of - from;
          const double       area = line[0] * way[1] - line[1] * way[0];
          return (area > 0) - (area < 0);
        };
      return side(a, b, c) * side(a, b, d) < 0 &&
             side(c, d, a) * side(c, d, b) < 0;
    }


    /** Two segments of a polygon that cross; none if it does not cross
     * itself. */
    std::optional<std::pair<unsigned int, unsigned int>>
    find_crossing(const Polygon &polygon)
    {
      // only segments that overlap along the longer side of its box can cross
      std::array<double, 2> extent;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto [least, greatest] = std::minmax_element(
            polygon.begin(),
            polygon.end(),
            [d](const Point<2> &a, const Point<2> &b) { return a[d] < b[d]; });
          extent[d] = (*greatest)[d] - (*least)[d];
        }
      const unsigned int d     = (extent[0] > extent[1] ? 0 : 1);
      const auto         begin = [&](const unsigned int i) {
        return std::min(polygon[i][d], polygon[i + 1][d]);
      };
      const auto end = [&](const unsigned int i) {
        return std::max(polygon[i][d], polygon[i + 1][d]);
      };
      std::vector<unsigned int> segments(polygon.size() - 1);
      std::iota(segments.begin(), segments.end(), 0);
      std::sort(segments.begin(),
                segments.end(),
                [&](const unsigned int i, const unsigned int j) {
                  return begin(i) < begin(j);
                });
      for (auto i = segments.begin(); i != segments.end(); ++i)
        for (auto j = i + 1; j != segments.end() && begin(*j) <= end(*i); ++j)
          if (cross(polygon[*i], polygon[*i + 1], polygon[*j], polygon[*j + 1]))
            return std::minmax(*i, *j);
      return {};
    }
  } // namespace


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
        if (i > 0 && i + 1 < points.size())
          {
            // the curve turns by at most 120 degrees at a point
            constexpr double   least_cosine = -0.5;
            const Tensor<1, 2> before       = points[i] - points[i - 1];
            const Tensor<1, 2> after        = points[i + 1] - points[i];
            if (before * after < least_cosine * before.norm() * after.norm())
              throw InputError(where + "must not turn the curve by more than "
                                       "120 degrees.");
          }
        knots.push_back(way);
        r.push_back(points[i][0]);
        y.push_back(points[i][1]);
      }
    radius = std::make_unique<Functions::CSpline<1>>(knots, r);
    axial  = std::make_unique<Functions::CSpline<1>>(knots, y);

    // starts for Newton's method in parameter_of(), and the polygon below
    constexpr unsigned int n_samples = 4;
    for (unsigned int i = 0; i + 1 < knots.size(); ++i)
      for (unsigned int k = 0; k <= n_samples; ++k)
        {
          const double s = knots[i] + (knots[i + 1] - knots[i]) * k / n_samples;
          samples.emplace_back(s, evaluate(s).position);
        }

    // intervals share their ends
    Polygon polygon;
    for (unsigned int i = 0; i < samples.size(); ++i)
      if (i % (n_samples + 1) < n_samples || i + 1 == samples.size())
        polygon.push_back(samples[i].second);
    if (const auto crossing = find_crossing(polygon))
      {
        const auto point = [&](const unsigned int segment) {
          return std::to_string(1 + segment / n_samples);
        };
        throw InputError(
          name + ": the curve crosses itself, after its points " +
          point(crossing->first) + " and " + point(crossing->second) +
          ", but a meridian must not meet itself.");
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
