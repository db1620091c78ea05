// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>

#include <biface/contact/height_field.h>
#include <biface/input/grid_data.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The derivatives at its knots of a cubic spline that is level at both
     * ends. */
    std::vector<double>
    spline_slopes(const std::vector<double> &x, const std::vector<double> &y)
    {
      const unsigned int  n = x.size();
      std::vector<double> slopes(n), factors(n);
      // the curvature is continuous at the inner knots: a tridiagonal system
      // for the slopes, eliminated upward and solved downward
      for (unsigned int i = 1; i + 1 < n; ++i)
        {
          const double before = 1 / (x[i] - x[i - 1]),
                       after  = 1 / (x[i + 1] - x[i]);
          const double pivot  = 2 * (before + after) - before * factors[i - 1];
          factors[i]          = after / pivot;
          slopes[i]           = (3 * (before * before * (y[i] - y[i - 1]) +
                            after * after * (y[i + 1] - y[i])) -
                       before * slopes[i - 1]) /
                      pivot;
        }
      for (unsigned int i = n - 1; i-- > 1;)
        slopes[i] -= factors[i] * slopes[i + 1];
      return slopes;
    }
  } // namespace


  HeightField::HeightField(const std::vector<Point<3>> &points,
                           const Tensor<1, 3>          &across,
                           const Tensor<1, 3>          &along,
                           const Tensor<1, 3>          &up,
                           const std::string           &name)
    : axes{{across, along, up}}
  {
    const GridData     data(points, {{"u", "v", "height"}}, name);
    const auto        &grid = data.rows;
    const unsigned int n = grid[0].size(), m = grid[1].size();
    knots.resize(data.values.size());
    for (std::size_t k = 0; k < knots.size(); ++k)
      knots[k][0] = data.values[k];
    // by u, by v, and of the derivative by u by v
    const auto differentiate = [&](const unsigned int d,
                                   const unsigned int from,
                                   const unsigned int to) {
      const unsigned int n_lines = (d == 0 ? m : n), stride = (d == 0 ? m : 1);
      for (unsigned int line = 0; line < n_lines; ++line)
        {
          const std::size_t   first = (d == 0 ? line : std::size_t(line) * m);
          std::vector<double> values;
          for (std::size_t i = 0; i < grid[d].size(); ++i)
            values.push_back(knots[first + i * stride][from]);
          const auto slopes = spline_slopes(grid[d], values);
          for (std::size_t i = 0; i < slopes.size(); ++i)
            knots[first + i * stride][to] = slopes[i];
        }
    };
    differentiate(0, 0, 1);
    differentiate(1, 0, 2);
    differentiate(1, 1, 3);

    smallest_cell = std::numeric_limits<double>::infinity();
    for (unsigned int d = 0; d < 2; ++d)
      for (unsigned int i = 1; i < grid[d].size(); ++i)
        smallest_cell = std::min(smallest_cell, grid[d][i] - grid[d][i - 1]);
    // the cells around the grid, in which the height of its edge goes on, reach
    // far beyond any shell
    const double far = 1e6 * (grid[0].back() - grid[0].front() +
                              grid[1].back() - grid[1].front());
    for (unsigned int d = 0; d < 2; ++d)
      {
        rows[d].push_back(grid[d].front() - far);
        rows[d].insert(rows[d].end(), grid[d].begin(), grid[d].end());
        rows[d].push_back(grid[d].back() + far);
      }
    boxes.reserve(2 * std::size_t(n + 1) * (m + 1));
    add_box({{0, 0}}, {{n + 1, m + 1}});
  }


  const HeightField::Knot &
  HeightField::knot(const unsigned int i, const unsigned int j) const
  {
    const unsigned int n = rows[0].size() - 2, m = rows[1].size() - 2;
    return knots[std::size_t(std::clamp(i, 1U, n) - 1) * m +
                 std::clamp(j, 1U, m) - 1];
  }


  unsigned int
  HeightField::add_box(const std::array<unsigned int, 2> &begin,
                       const std::array<unsigned int, 2> &end)
  {
    const unsigned int number = boxes.size();
    boxes.push_back({begin,
                     end,
                     std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity(),
                     {{0, 0}}});
    const unsigned int d   = (end[0] - begin[0] >= end[1] - begin[1]) ? 0 : 1;
    Box                box = boxes.back();
    if (end[d] - begin[d] > 1)
      {
        auto end_of_first = end, begin_of_second = begin;
        end_of_first[d] = begin_of_second[d] = (begin[d] + end[d]) / 2;
        box.parts[0]                         = add_box(begin, end_of_first);
        box.parts[1]                         = add_box(begin_of_second, end);
        for (const unsigned int part : box.parts)
          {
            box.lowest  = std::min(box.lowest, boxes[part].lowest);
            box.highest = std::max(box.highest, boxes[part].highest);
          }
      }
    else
      {
        // a cell lies between its control points
        const double du = (rows[0][end[0]] - rows[0][begin[0]]) / 3,
                     dv = (rows[1][end[1]] - rows[1][begin[1]]) / 3;
        for (const unsigned int i : {0, 1})
          for (const unsigned int j : {0, 1})
            {
              const Knot &at = knot(begin[0] + i, begin[1] + j);
              for (const double u : {0., i == 0 ? du : -du})
                for (const double v : {0., j == 0 ? dv : -dv})
                  {
                    const double height =
                      at[0] + u * at[1] + v * at[2] + u * v * at[3];
                    box.lowest  = std::min(box.lowest, height);
                    box.highest = std::max(box.highest, height);
                  }
            }
      }
    boxes[number] = box;
    return number;
  }


  unsigned int
  HeightField::find_cell(const unsigned int direction,
                         const double       coordinate) const
  {
    const auto &x = rows[direction];
    // without the outermost lines, so that no coordinate lies outside of all
    // cells
    return std::upper_bound(x.begin() + 1, x.end() - 1, coordinate) -
           x.begin() - 1;
  }


  std::array<double, 4>
  HeightField::basis(const unsigned int direction,
                     const unsigned int cell,
                     const double       coordinate,
                     const unsigned int derivative) const
  {
    const double begin  = rows[direction][cell],
                 length = rows[direction][cell + 1] - begin;
    const double t      = std::clamp((coordinate - begin) / length, 0., 1.);
    // Hermite's polynomials: slopes at the knots count by the length of the
    // cell, and each derivative divides by it
    switch (derivative)
      {
        case 0:
          {
            const double upper = t * t * (3 - 2 * t);
            return {{1 - upper,
                     length * t * (1 - t) * (1 - t),
                     upper,
                     -length * t * t * (1 - t)}};
          }
        case 1:
          {
            const double upper = 6 * t * (1 - t) / length;
            return {{-upper, (1 - t) * (1 - 3 * t), upper, t * (3 * t - 2)}};
          }
        default:
          {
            const double upper = (6 - 12 * t) / (length * length);
            return {
              {-upper, (6 * t - 4) / length, upper, (6 * t - 2) / length}};
          }
      }
  }


  double
  HeightField::height(const Point<2>                    &x,
                      const std::array<unsigned int, 2> &order) const
  {
    const unsigned int i = find_cell(0, x[0]), j = find_cell(1, x[1]);
    const auto u = basis(0, i, x[0], order[0]), v = basis(1, j, x[1], order[1]);
    double     result = 0;
    for (const unsigned int k : {0, 1})
      for (const unsigned int l : {0, 1})
        {
          const Knot &at = knot(i + k, j + l);
          result += u[2 * k] * (v[2 * l] * at[0] + v[2 * l + 1] * at[2]) +
                    u[2 * k + 1] * (v[2 * l] * at[1] + v[2 * l + 1] * at[3]);
        }
    return result;
  }


  double
  HeightField::value(const Point<3> &x) const
  {
    const Point<3> y = coordinates(x);
    return y[2] - height(Point<2>(y[0], y[1]), {{0, 0}});
  }


  ImplicitSurface::Derivatives
  HeightField::derivatives(const Point<3> &x) const
  {
    const Point<3> y = coordinates(x);
    const Point<2> at(y[0], y[1]);
    Derivatives    result;
    // of the function y_3 - height(y_1, y_2), which is no distance: its
    // gradient is longer than 1 where the surface slopes
    result.gradient =
      axes[2] - height(at, {{1, 0}}) * axes[0] - height(at, {{0, 1}}) * axes[1];
    result.hessian =
      -(height(at, {{2, 0}}) * symmetrize(outer_product(axes[0], axes[0])) +
        height(at, {{0, 2}}) * symmetrize(outer_product(axes[1], axes[1])) +
        2 * height(at, {{1, 1}}) * symmetrize(outer_product(axes[0], axes[1])));
    return result;
  }


  double
  HeightField::distance_square(const Box &box, const Point<3> &x) const
  {
    double square = 0;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double low  = (d < 2 ? rows[d][box.begin[d]] : box.lowest),
                     high = (d < 2 ? rows[d][box.end[d]] : box.highest);
        const double way  = std::clamp(x[d], low, high) - x[d];
        square += way * way;
      }
    return square;
  }


  void
  HeightField::search_box(const unsigned int number,
                          const Point<3>    &x,
                          const Search      &search,
                          double            &distance) const
  {
    const Box &box = boxes[number];
    // nothing in the box can be closer than what is known
    if (distance_square(box, x) >= distance * distance)
      return;
    if (box.parts[1] == 0)
      {
        Point<2> start;
        for (unsigned int d = 0; d < 2; ++d)
          start[d] =
            std::clamp(x[d], rows[d][box.begin[d]], rows[d][box.end[d]]);
        const Point<3> found =
          search(Point<3>(start[0] * axes[0] + start[1] * axes[1] +
                          height(start, {{0, 0}}) * axes[2]));
        distance = x.distance(coordinates(found));
        return;
      }
    // the closer half first: what it finds mostly excludes the other one
    auto parts = box.parts;
    if (distance_square(boxes[parts[1]], x) <
        distance_square(boxes[parts[0]], x))
      std::swap(parts[0], parts[1]);
    for (const unsigned int part : parts)
      search_box(part, x, search, distance);
  }


  void
  HeightField::search_closest(const Point<3> &x, const Search &search) const
  {
    double distance = std::numeric_limits<double>::infinity();
    search_box(0, coordinates(x), search, distance);
  }
} // namespace Biface
