// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/contact/body_section.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }


    /** The unit vector to the left of another. */
    Tensor<1, 2>
    left_of(const Tensor<1, 2> &along)
    {
      return Tensor<1, 2>({-along[1], along[0]});
    }
  } // namespace


  SectionPoint
  Disk::evaluate(const Point<2> &x) const
  {
    // with a negative radius the distance from the center is negative, too: the
    // inside of the circle is outside of the body
    const Tensor<1, 2> arm   = x - center;
    const double       rho   = std::copysign(arm.norm(), radius);
    const Tensor<1, 2> along = (rho != 0 ? arm / rho : Tensor<1, 2>({1., 0.}));
    return {rho - radius, along, 1 / rho};
  }


  RoundedPolygon::RoundedPolygon(std::vector<Corner> corners,
                                 const std::string  &entry)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    const auto text = [&](const unsigned int i) {
      return number_to_string(corners[i].point[0]) + " " +
             number_to_string(corners[i].point[1]);
    };
    const auto number = [](const unsigned int i) {
      return "corner " + std::to_string(i + 1);
    };
    for (const Corner &corner : corners)
      check_not_negative(entry, corner.radius);
    const bool closed =
      corners.size() > 1 && corners.front().point == corners.back().point;
    if (corners.size() < (closed ? 4 : 2))
      throw InputError(entry,
                       corners.empty() ? "" : text(0),
                       "the polygon must have at least two corners, or three "
                       "and the first one again if it is closed");
    const unsigned int n = corners.size() - 1;
    if (closed)
      {
        double &first = corners.front().radius, &last = corners.back().radius;
        if (first > 0 && last > 0 && first != last)
          throw InputError(entry,
                           number_to_string(last),
                           "the first corner, which is repeated, has the "
                           "radius " +
                             number_to_string(first));
        first = last = std::max(first, last);
      }

    for (unsigned int i = 0; i < n; ++i)
      {
        const Tensor<1, 2> way = corners[i + 1].point - corners[i].point;
        if (way.norm() == 0)
          throw InputError(
            entry, text(i), number(i) + " and the next one must differ");
        lines.push_back({corners[i].point, way / way.norm(), 0, way.norm()});
      }

    // the region of a closed polygon is inside
    double area = 0;
    for (unsigned int i = 0; i < n; ++i)
      area += cross(Tensor<1, 2>(corners[i].point - corners[0].point),
                    Tensor<1, 2>(corners[i + 1].point - corners[0].point));
    if (closed && area > 0)
      {
        std::vector<Corner> reversed(corners.rbegin(), corners.rend());
        *this = RoundedPolygon(reversed, entry);
        return;
      }

    for (unsigned int i = 0; i < n; ++i)
      // where lines cross, the right side of one is the left side of the other,
      // and there is no inside
      for (unsigned int j = i + 2; j < n; ++j)
        {
          if (closed && i == 0 && j == n - 1)
            continue;
          const Line        &a = lines[i], &b = lines[j];
          const Tensor<1, 2> between = b.start - a.start;
          const double       sine    = cross(a.along, b.along);
          if (sine == 0)
            continue;
          const double on_a = cross(between, b.along) / sine,
                       on_b = cross(between, a.along) / sine;
          // the first and last line of an open polygon go on
          const bool meets_a =
            on_a <= a.end && on_a >= (!closed && i == 0 ? -infinity : a.begin);
          const bool meets_b =
            on_b >= b.begin &&
            on_b <= (!closed && j == n - 1 ? infinity : b.end);
          if (meets_a && meets_b)
            throw InputError(entry,
                             text(i),
                             "the polygon must not cross itself after " +
                               number(i));
        }

    for (unsigned int i = 0; i < n; ++i)
      {
        if (!closed && i == n - 1)
          break;
        const unsigned int next   = (i + 1) % n;
        const Corner      &corner = corners[i + 1];
        const Tensor<1, 2> a = lines[i].along, b = lines[next].along;
        const double       sine = cross(a, b), cosine = a * b;
        if (sine == 0 && cosine > 0)
          continue;
        if (std::abs(sine) < 1e-6 && cosine < 0)
          throw InputError(entry,
                           text(i + 1),
                           "the polygon must not turn back at " +
                             number(i + 1));
        // an arc touches both lines: it takes r tan(turn/2) off each of them
        const double cut =
          corner.radius * std::tan(std::atan2(std::abs(sine), cosine) / 2);
        lines[i].end -= cut;
        lines[next].begin += cut;
        // the body is to the right of the polygon, so that a turn to the right
        // is convex
        const bool convex = sine < 0;
        arcs.push_back({corner.point - cut * a -
                          (convex ? 1 : -1) * corner.radius * left_of(a),
                        corner.radius,
                        convex,
                        left_of(a),
                        left_of(b)});
      }
    for (unsigned int i = 0; i < n; ++i)
      if (lines[i].end < lines[i].begin)
        throw InputError(entry,
                         text(i),
                         "there must be room for the radii between " +
                           number(i) + " and the next one");
    if (!closed)
      {
        lines.front().begin = -infinity;
        lines.back().end    = infinity;
      }
  }


  SectionPoint
  RoundedPolygon::evaluate(const Point<2> &x) const
  {
    // lines and arcs overlap, lest round-off open gaps between them
    constexpr double overlap = 1e-9;

    SectionPoint nearest{std::numeric_limits<double>::infinity(), {}, 0};
    const auto   propose = [&](const SectionPoint &candidate) {
      if (std::abs(candidate.distance) < std::abs(nearest.distance))
        nearest = candidate;
    };
    for (const Line &line : lines)
      {
        const Tensor<1, 2> arm   = x - line.start;
        const double       where = arm * line.along;
        const Tensor<1, 2> out   = left_of(line.along);
        const double       more  = overlap * arm.norm();
        if (where >= line.begin - more && where <= line.end + more)
          propose({arm * out, out, 0});
      }
    for (const Arc &arc : arcs)
      {
        const double       side = (arc.convex ? 1 : -1);
        const Tensor<1, 2> arm  = x - arc.center;
        const double       rho  = arm.norm();
        // in the sector between the normals
        if (cross(arc.first, arm) > overlap * rho ||
            cross(arm, arc.last) > overlap * rho)
          continue;
        // the center of an arc has no normal from it; the ends of the lines
        // beside the arc are as close
        if (rho == 0 && arc.radius > 0)
          continue;
        const Tensor<1, 2> middle = arc.first + arc.last;
        propose({side * (rho - arc.radius),
                 rho > 0 ? side * arm / rho : middle / middle.norm(),
                 rho > 0 ? side / rho : 0});
      }
    Assert(std::isfinite(nearest.distance), ExcInternalError());
    return nearest;
  }


  std::vector<double>
  RoundedPolygon::radii() const
  {
    std::vector<double> result;
    for (const Arc &arc : arcs)
      result.push_back(arc.radius);
    return result;
  }
} // namespace Biface
