// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/input/grid_data.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The different values of a coordinate, in order. */
    std::vector<double>
    rows_of_grid(const std::vector<Point<3>> &points,
                 const unsigned int           direction)
    {
      std::vector<double> all;
      for (const Point<3> &point : points)
        all.push_back(point[direction]);
      std::sort(all.begin(), all.end());
      // the same number may have been computed in several ways
      const double        round_off = 1e-9 * (all.back() - all.front());
      std::vector<double> rows;
      for (const double coordinate : all)
        if (rows.empty() || coordinate > rows.back() + round_off)
          rows.push_back(coordinate);
      return rows;
    }
  } // namespace


  GridData::GridData(std::vector<Point<3>>             points,
                     const std::array<std::string, 3> &columns,
                     const std::string                &name)
  {
    if (points.size() < 4)
      throw InputError(name + ": there must be at least two rows of points in "
                              "both directions.");
    for (unsigned int d = 0; d < 2; ++d)
      {
        rows[d] = rows_of_grid(points, d);
        if (rows[d].size() < 2)
          throw InputError(name + ": the points must not all have the same " +
                           columns[d] + ", " + number_to_string(rows[d][0]) +
                           ".");
        for (Point<3> &point : points)
          {
            // points of a row have the same coordinate from here on, so that
            // the order below is exact
            auto row =
              std::upper_bound(rows[d].begin(), rows[d].end(), point[d]);
            point[d] = *--row;
          }
      }
    std::sort(points.begin(), points.end(), [](const auto &a, const auto &b) {
      return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
    });
    // with all points in order, the first deviation from the full grid tells
    // which one is missing
    const unsigned int n = rows[0].size(), m = rows[1].size();
    const auto         at = [&](const double u, const double v) {
      return "at " + columns[0] + " = " + number_to_string(u) + ", " +
             columns[1] + " = " + number_to_string(v);
    };
    for (std::size_t k = 1; k < points.size(); ++k)
      if (points[k][0] == points[k - 1][0] && points[k][1] == points[k - 1][1])
        throw InputError(name + ": the " + columns[2] + " " +
                         at(points[k][0], points[k][1]) +
                         " must be given only once.");
    for (std::size_t k = 0; k <= points.size() && k < std::size_t(n) * m; ++k)
      {
        const double u = rows[0][k / m], v = rows[1][k % m];
        if (k == points.size() || points[k][0] != u || points[k][1] != v)
          throw InputError(name + ": there is no " + columns[2] + " " +
                           at(u, v) +
                           ", but the points must form a rectangular grid.");
      }
    for (const Point<3> &point : points)
      values.push_back(point[2]);
  }
} // namespace Biface
