// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
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
      // the ends of each on both sides of the other; an end on the other does
      // not count
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

    /** The polynomial of fifth degree between two points of curves, see
     * SplineCurve::Rounding. */
    std::array<Tensor<1, 2>, 6>
    quintic(const Meridian::PointOfCurve &a,
            const Meridian::PointOfCurve &b,
            const double                  length)
    {
      const Tensor<1, 2> p_0 = a.position, p_1 = b.position;
      const Tensor<1, 2> d_0  = length * a.first_derivative;
      const Tensor<1, 2> d_1  = length * b.first_derivative;
      const Tensor<1, 2> dd_0 = length * length * a.second_derivative;
      const Tensor<1, 2> dd_1 = length * length * b.second_derivative;
      // what the first three terms leave at the other end
      const Tensor<1, 2> p  = p_1 - p_0 - d_0 - dd_0 / 2;
      const Tensor<1, 2> d  = d_1 - d_0 - dd_0;
      const Tensor<1, 2> dd = dd_1 - dd_0;
      return {{p_0,
               d_0,
               dd_0 / 2,
               10 * p - 4 * d + dd / 2,
               -15 * p + 7 * d - dd,
               6 * p - 3 * d + dd / 2}};
    }


    /** The points of a file. Throws InputError if they cannot be those of a
     * meridian. */
    Contour
    checked_contour(const std::vector<Point<2>> &points,
                    const std::string           &name)
    {
      // for each node, the foot of a perpendicular is sought among all points
      constexpr unsigned int max_points = 10000;
      if (points.size() > max_points)
        throw InputError(name + ": the curve has " +
                         std::to_string(points.size()) +
                         " points, but at most " + std::to_string(max_points) +
                         " are allowed.");
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
        }
      const Contour contour(points, name);
      if (contour.points.size() < 3)
        throw InputError(name + ": the curve has " +
                         std::to_string(contour.points.size()) +
                         " points, but a spline needs at least 3.");
      return contour;
    }


    std::string
    in_degrees(const double angle)
    {
      return number_to_string(std::round(angle * 180 / numbers::PI)) +
             " degrees";
    }


    // between two neighboring points
    constexpr unsigned int n_samples = 4;
    // from one sample to the next that is tried first
    constexpr std::size_t stride = 16;
  } // namespace


  SplineCurve::SplineCurve(const std::vector<Point<2>> &points,
                           const std::string           &name,
                           const double                 corner_radius)
  {
    const Contour contour = checked_contour(points, name);
    remarks               = contour.remarks;
    set_knots(contour, name);

    unsigned int first = 0;
    if (corner_radius > 0)
      for (const Contour::Kink &kink : contour.kinks)
        {
          parts.push_back(make_part(contour.points, first, kink.index));
          first = kink.index;
        }
    parts.push_back(make_part(contour.points, first, knots.size() - 1));
    if (corner_radius > 0 && contour.kinks.empty())
      remarks.push_back(name +
                        ": the curve has no kinks, and 'Corner radius' in "
                        "'Surface/Spline' has no effect.");
    if (corner_radius > 0)
      round_corners(contour, name, corner_radius);
    else
      for (const Contour::Kink &kink : contour.kinks)
        remarks.push_back(
          name + ": at " + contour.describe(kink.index) +
          ", there is a kink of " + in_degrees(kink.angle) +
          ", beside which the spline swings; give more points there if it is "
          "round, or a 'Corner radius' in 'Surface/Spline'.");

    for (unsigned int i = 0; i + 1 < knots.size(); ++i)
      for (unsigned int k = 0; k <= n_samples; ++k)
        {
          const double s = knots[i] + (knots[i + 1] - knots[i]) * k / n_samples;
          samples.emplace_back(s, evaluate(s).position);
        }
    check_crossing(contour, name);
    // the knots alone would miss corners, which are shorter than what lies
    // between them
    for (const Rounding &rounding : roundings)
      for (unsigned int k = 0; k <= 4 * n_samples; ++k)
        {
          const double s = rounding.begin + (rounding.end - rounding.begin) *
                                              k / (4 * n_samples);
          samples.emplace_back(s, evaluate(s).position);
        }
    std::stable_sort(
      samples.begin(), samples.end(), [](const auto &a, const auto &b) {
        return a.first < b.first;
      });
    for (std::size_t i = 1; i < samples.size(); ++i)
      largest_step = std::max(
        largest_step, samples[i].second.distance(samples[i - 1].second));
  }


  void
  SplineCurve::set_knots(const Contour &contour, const std::string &name)
  {
    const std::vector<Point<2>> &points = contour.points;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const std::string where = name + ": " + contour.describe(i) + ", ";
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
        // alpha_1 is the length along the polygon, not that of the spline
        knots.push_back(way);
      }
  }


  SplineCurve::Part
  SplineCurve::make_part(const std::vector<Point<2>> &points,
                         const unsigned int           first,
                         const unsigned int           last) const
  {
    std::vector<double> s, r, y;
    for (unsigned int i = first; i <= last; ++i)
      {
        s.push_back(knots[i]);
        r.push_back(points[i][0]);
        y.push_back(points[i][1]);
        // a straight line, for which a spline needs a third point
        if (last == first + 1 && i == first)
          {
            s.push_back((knots[i] + knots[i + 1]) / 2);
            r.push_back((points[i][0] + points[i + 1][0]) / 2);
            y.push_back((points[i][1] + points[i + 1][1]) / 2);
          }
      }
    return {s.front(),
            s.back(),
            std::make_shared<Functions::CSpline<1>>(s, r),
            std::make_shared<Functions::CSpline<1>>(s, y)};
  }


  void
  SplineCurve::round_corners(const Contour     &contour,
                             const std::string &name,
                             const double       corner_radius)
  {
    // of the lengths on both sides, relative to the radius
    std::vector<double> factors;
    // the tangents of the splines on both sides, not the polygon
    for (unsigned int k = 0; k + 1 < parts.size(); ++k)
      {
        const double       s      = parts[k].end;
        const Tensor<1, 2> before = parts[k].evaluate(s).first_derivative;
        const Tensor<1, 2> after  = parts[k + 1].evaluate(s).first_derivative;
        const double       half =
          std::acos(std::clamp(
            before * after / (before.norm() * after.norm()), -1., 1.)) /
          2;
        // the polynomial between straight lines is sharpest in its middle
        factors.push_back(1.5 * std::sin(half) /
                          (std::cos(half) * std::cos(half)));
        const double turn = before[0] * after[1] - before[1] * after[0];
        corners.push_back({s, turn > 0 ? corner_radius : -corner_radius});
      }
    for (unsigned int k = 0; k < factors.size(); ++k)
      {
        // a part between two corners has room for both
        const double before = (parts[k].end - parts[k].begin) / (k > 0 ? 2 : 1);
        const double after  = (parts[k + 1].end - parts[k + 1].begin) /
                             (k + 1 < factors.size() ? 2 : 1);
        const double      room   = std::min(before, after);
        const double      length = factors[k] * corner_radius;
        const std::string where  = contour.describe(contour.kinks[k].index);
        if (!(length < room))
          throw InputError("Surface/Spline/Corner radius",
                           number_to_string(corner_radius),
                           "it must be less than " +
                             number_to_string(room / factors[k]) +
                             " for the kink at " + where);
        const double s     = parts[k].end;
        const double begin = s - length, end = s + length;
        roundings.push_back({begin,
                             end,
                             quintic(parts[k].evaluate(begin),
                                     parts[k + 1].evaluate(end),
                                     end - begin)});
        char interval[64];
        std::snprintf(interval, sizeof(interval), "%.5g to %.5g", begin, end);
        remarks.push_back(
          name + ": the kink of " + in_degrees(contour.kinks[k].angle) +
          " at " + where + ", is a corner with the radius " +
          number_to_string(corner_radius) + " from alpha_1 = " + interval +
          ", which the lines of the mesh must resolve.");
      }
  }


  void
  SplineCurve::check_crossing(const Contour &contour, const std::string &name)
  {
    // intervals share their ends
    Polygon polygon;
    for (unsigned int i = 0; i < samples.size(); ++i)
      if (i % (n_samples + 1) < n_samples || i + 1 == samples.size())
        polygon.push_back(samples[i].second);
    if (const auto crossing = find_crossing(polygon))
      {
        const auto point = [&](const unsigned int segment) {
          return std::to_string(contour.numbers[segment / n_samples]);
        };
        throw InputError(
          name + ": the curve crosses itself, after its points " +
          point(crossing->first) + " and " + point(crossing->second) +
          ", but a meridian must not meet itself.");
      }
  }


  Meridian::PointOfCurve
  SplineCurve::Part::evaluate(const double s) const
  {
    const Point<1> knot(s);
    return {
      Point<2>(radius->value(knot), axial->value(knot)),
      Tensor<1, 2>({radius->gradient(knot)[0], axial->gradient(knot)[0]}),
      Tensor<1, 2>({radius->hessian(knot)[0][0], axial->hessian(knot)[0][0]})};
  }


  Meridian::PointOfCurve
  SplineCurve::evaluate(const double s) const
  {
    // the end points, up to round-off
    const double knot = std::min(std::max(s, knots.front()), knots.back());
    for (unsigned int k = 0; k < roundings.size(); ++k)
      {
        const Rounding &rounding = roundings[k];
        if (knot <= rounding.begin)
          return parts[k].evaluate(knot);
        if (knot >= rounding.end)
          continue;
        const double length = rounding.end - rounding.begin;
        const double x      = (knot - rounding.begin) / length;
        Tensor<1, 2> position, first, second;
        // Horner's scheme, with that of the derivatives
        for (unsigned int i = 6; i-- > 0;)
          {
            second   = x * second + 2 * first;
            first    = x * first + position;
            position = x * position + rounding.coefficients[i];
          }
        return {Point<2>(position), first / length, second / (length * length)};
      }
    return parts.back().evaluate(knot);
  }


  double
  SplineCurve::nearest_sample(const Point<2> &point) const
  {
    const auto distance = [&](const std::size_t i) {
      return samples[i].second.distance(point);
    };
    std::size_t nearest = 0;
    double      least   = distance(0);
    const auto  visit   = [&](const std::size_t i) {
      const double d = distance(i);
      if (d < least)
        {
          nearest = i;
          least   = d;
        }
      return d;
    };
    for (std::size_t i = stride; i < samples.size(); i += stride)
      visit(i);
    // those that cannot be nearer are left out: from one sample to the next,
    // the distance decreases by at most the largest step
    for (std::size_t i = 0; i < samples.size();)
      {
        const double surplus = visit(i) - least;
        i += 1 + static_cast<std::size_t>(surplus / largest_step);
      }
    return samples[nearest].first;
  }


  double
  SplineCurve::parameter_of(const Point<2> &point) const
  {
    // the nearest of the samples, then Newton's method for the foot of the
    // perpendicular
    double best = nearest_sample(point);
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
