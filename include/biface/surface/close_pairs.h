// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_close_pairs_h
#define biface_surface_close_pairs_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <vector>

namespace Biface
{
  /** Call a function for each pair of points that are at most @p distance
   * apart, with their positions in @p points.
   * @param chosen the positions of the points that are compared. */
  template <typename Function>
  void
  for_close_pairs(const std::vector<dealii::Point<3>> &points,
                  std::vector<unsigned int>            chosen,
                  const double                         distance,
                  const Function                      &function)
  {
    // along x, so that few pairs need to be compared
    std::sort(chosen.begin(),
              chosen.end(),
              [&](const unsigned int a, const unsigned int b) {
                return points[a][0] < points[b][0];
              });
    for (auto a = chosen.begin(); a != chosen.end(); ++a)
      for (auto b = a + 1;
           b != chosen.end() && points[*b][0] - points[*a][0] <= distance;
           ++b)
        if (points[*a].distance(points[*b]) <= distance)
          function(*a, *b);
  }
} // namespace Biface

#endif
