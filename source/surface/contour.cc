// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/input/parameter_tools.h>
#include <biface/surface/contour.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Points = std::vector<Point<2>>;

    // lengths of a group of points relative to its neighbors: where it may be
    // one point, and where it is one in any direction
    constexpr double largest_group = 0.1;
    constexpr double round_off     = 1e-6;

    // directions that a smooth curve may have beside those of its neighbors in
    // a group of the largest length
    const double small_angle = 2 * numbers::PI / 180;

    const double     least_kink     = 15 * numbers::PI / 180;
    constexpr double kink_to_others = 4;
    // where no neighbor tells: twelve points are enough for a circle
    const double sure_kink = 30 * numbers::PI / 180;


    /** The angle by which a direction turns to another one, positive to the
     * left. */
    double
    angle_between(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
    }


    /** The turn of a polygon at a point; 0 at its ends. */
    double
    turn_at(const Points &points, const unsigned int i)
    {
      return i == 0 || i + 1 >= points.size()
               ? 0.
               : angle_between(points[i] - points[i - 1],
                               points[i + 1] - points[i]);
    }


    /** Whether a smooth curve passes through the points from @p first to
     * @p last: their directions are between those before and after them.
     * @param length of the group as a part of the largest one; in a short one
     * little noise turns them far. */
    bool
    is_smooth(const Points      &points,
              const unsigned int first,
              const unsigned int last,
              const double       length)
    {
      const bool         has_before = (first > 0);
      const bool         has_after  = (last + 1 < points.size());
      const Tensor<1, 2> before = has_before ? points[first] - points[first - 1]
                                             : points[last + 1] - points[last];
      double             low = 0, high = 0;
      if (has_before && has_after)
        {
          const double turn =
            angle_between(before, points[last + 1] - points[last]);
          low  = std::min(turn, 0.);
          high = std::max(turn, 0.);
        }
      else
        {
          // at an end the curve may go on to turn as it does at the far end of
          // the segment beside it
          high = std::abs(turn_at(points, has_before ? first - 1 : last + 1));
          low  = -high;
        }
      for (unsigned int i = first; i < last; ++i)
        {
          const double direction =
            angle_between(before, points[i + 1] - points[i]);
          if (direction < low - length * small_angle ||
              direction > high + length * small_angle)
            return false;
        }
      return true;
    }
  } // namespace


  unsigned int
  Contour::end_of_group(const Points &all, const unsigned int first) const
  {
    const double infinite = std::numeric_limits<double>::infinity();
    const double before =
      (points.empty() ? infinite : all[first].distance(points.back()));
    unsigned int result = first;
    double       length = 0;
    for (unsigned int last = first + 1; last < all.size(); ++last)
      {
        length += all[last].distance(all[last - 1]);
        if (length > largest_group * before)
          break;
        const double after =
          (last + 1 < all.size() ? all[last + 1].distance(all[last])
                                 : infinite);
        const double neighbor = std::min(before, after);
        // not the whole curve
        if (neighbor == infinite)
          break;
        if (length <= round_off * neighbor ||
            (length <= largest_group * neighbor &&
             !is_smooth(all, first, last, length / (largest_group * neighbor))))
          result = last;
      }
    return result;
  }


  Contour::Contour(const Points &all, const std::string &name)
  {
    for (unsigned int first = 0; first < all.size();)
      {
        const unsigned int last = end_of_group(all, first);
        // the ends of the curve remain
        const unsigned int kept =
          (last + 1 == all.size() && first > 0 ? last : first);
        points.push_back(all[kept]);
        numbers.push_back(kept + 1);
        if (last > first)
          {
            double length = 0;
            for (unsigned int i = first; i < last; ++i)
              length += all[i].distance(all[i + 1]);
            remarks.push_back(
              name + ": the points " + std::to_string(first + 1) + " to " +
              std::to_string(last + 1) + " of the curve, from (" +
              number_to_string(all[first][0]) + ", " +
              number_to_string(all[first][1]) +
              ") on, are taken as one, the point " + std::to_string(kept + 1) +
              ": together they are only " + number_to_string(length) +
              " long, at most 1/10 of the distances to their neighbors, and "
              "would make the spline swing.");
          }
        first = last + 1;
      }
    find_kinks();
  }


  void
  Contour::find_kinks()
  {
    std::vector<double> turns, curvatures;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        turns.push_back(std::abs(turn_at(points, i)));
        // the turn per length: large at a kink, where neighbors have little
        curvatures.push_back(i == 0 || i + 1 == points.size()
                               ? 0.
                               : turns[i] /
                                   (points[i].distance(points[i - 1]) +
                                    points[i].distance(points[i + 1])));
      }
    for (unsigned int i = 1; i + 1 < points.size(); ++i)
      {
        if (!(turns[i] > least_kink))
          continue;
        // beside neighbors that are no kinks themselves
        double others = -1;
        for (const unsigned int j : {i - 1, i + 1})
          if (j > 0 && j + 1 < points.size() && turns[j] <= least_kink)
            others = std::max(others, curvatures[j]);
        if (others < 0 ? turns[i] > sure_kink
                       : curvatures[i] > kink_to_others * others)
          kinks.push_back({i, turns[i]});
      }
  }


  std::string
  Contour::describe(const unsigned int index) const
  {
    return "the point " + std::to_string(numbers[index]) + " of the curve, (" +
           number_to_string(points[index][0]) + ", " +
           number_to_string(points[index][1]) + ")";
  }
} // namespace Biface
