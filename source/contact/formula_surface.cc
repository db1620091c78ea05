// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <biface/base/errors.h>
#include <biface/contact/formula_surface.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The directions to the neighbors of a cube. */
    std::vector<Tensor<1, 3>>
    directions_of_cube()
    {
      std::vector<Tensor<1, 3>> directions;
      for (const double x : {0., 1., -1.})
        for (const double y : {0., 1., -1.})
          for (const double z : {0., 1., -1.})
            if (x != 0 || y != 0 || z != 0)
              directions.push_back(Tensor<1, 3>({x, y, z}) /
                                   std::sqrt(x * x + y * y + z * z));
      return directions;
    }

    const std::vector<Tensor<1, 3>> directions = directions_of_cube();
  } // namespace


  FormulaSurface::FormulaSurface(const std::string &entry,
                                 const std::string &text,
                                 const std::string &size_entry,
                                 const double       size)
    : formula(entry, text, {"x", "y", "z"}), size(size), step(size / 50)
  {
    constexpr double finite = 10, farthest = 1000, growth = 1.25;

    // rays from the origin of the formula, in steps that grow with the distance
    // since the extent of the body is not known
    std::vector<Point<3>> found;
    for (const Tensor<1, 3> &direction : directions)
      {
        Point<3> from;
        double   before = formula({0., 0., 0.});
        for (double r = size / 10; r < farthest * size; r *= growth)
          {
            // close to the origin a formula without a value is refused; farther
            // away the ray ends there
            const Point<3> to(r * direction);
            const double   after =
              (r < finite * size ? formula({to[0], to[1], to[2]}) : value(to));
            if (!std::isfinite(after))
              break;
            if ((before < 0) != (after < 0))
              if (const auto surface = surface_between(from, to))
                {
                  found.push_back(*surface);
                  break;
                }
            from   = to;
            before = after;
          }
      }
    if (found.empty())
      throw InputError(entry,
                       text,
                       "it must change its sign, from negative in the body, "
                       "within 1000 times 'Size' from 'Point'");

    // a formula may have edges in some of the points
    bool is_regular = false, is_smooth = false;
    for (const Point<3> &x : found)
      {
        // the unit of a formula is arbitrary: whether its gradient vanishes is
        // asked relative to its values around
        const Tensor<1, 3> g       = gradient(x, step);
        double             largest = 0;
        for (const Tensor<1, 3> &direction : directions)
          largest = std::max(largest, std::abs(value(x + step * direction)));
        if (!(g.norm() * step > 1e-6 * largest))
          continue;
        is_regular = true;
        // also if details are far below the step
        double change = 0;
        for (double part = 0.5; part > 1e-6; part /= 16)
          change = std::max(change, (gradient(x, part * step) - g).norm());
        if (is_smooth || change > 1e-3 * g.norm())
          continue;
        known     = x;
        is_smooth = true;
      }
    if (!is_regular)
      throw InputError(
        entry, text, "its gradient must not be zero at the surface");
    if (!is_smooth)
      throw InputError(size_entry,
                       number_to_string(size),
                       "'Formula' must be smooth over this length");
  }


  std::array<double, 2>
  FormulaSurface::differences(const Point<3>     &x,
                              const Tensor<1, 3> &direction,
                              const double        value_at_x,
                              const double        step) const
  {
    // central differences of sixth order, from three points on each side
    constexpr std::array<double, 3> first{{45. / 60, -9. / 60, 1. / 60}},
      second{{270. / 180, -27. / 180, 2. / 180}};
    std::array<double, 2> result{{0, -490. / 180 * value_at_x}};
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double after  = value(x + (i + 1) * step * direction),
                     before = value(x - (i + 1) * step * direction);
        result[0] += first[i] * (after - before);
        result[1] += second[i] * (after + before);
      }
    return {{result[0] / step, result[1] / (step * step)}};
  }


  double
  FormulaSurface::value(const Point<3> &x) const
  {
    for (unsigned int i = 0; i < 3; ++i)
      values[i] = x[i];
    return formula.unchecked(values);
  }


  Tensor<1, 3>
  FormulaSurface::gradient(const Point<3> &x, const double step) const
  {
    Tensor<1, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = differences(x, Point<3>::unit_vector(i), 0, step)[0];
    return result;
  }


  ImplicitSurface::Derivatives
  FormulaSurface::derivatives(const Point<3> &x) const
  {
    const double at_x = value(x);
    Derivatives  result;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const auto along = differences(x, Point<3>::unit_vector(i), at_x, step);
        result.gradient[i]   = along[0];
        result.hessian[i][i] = along[1];
      }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          // the second derivative along the diagonal is the mean of those along
          // both axes plus the mixed one
          const Tensor<1, 3> diagonal =
            (Point<3>::unit_vector(i) + Point<3>::unit_vector(j)) /
            std::sqrt(2.);
          result.hessian[i][j] =
            differences(x, diagonal, at_x, step)[1] -
            (result.hessian[i][i] + result.hessian[j][j]) / 2;
        }
    return result;
  }


  std::optional<Point<3>>
  FormulaSurface::surface_between(Point<3> a, Point<3> b) const
  {
    double       at_a = value(a), at_b = value(b);
    const double limit = std::min(std::abs(at_a), std::abs(at_b));
    // the method of false position, with bisection while it is slow
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      {
        const Tensor<1, 3> way = b - a;
        if (way.norm() <=
            1e-14 * size + 4 * std::numeric_limits<double>::epsilon() *
                             (a - Point<3>()).norm())
          break;
        const double   part = (iteration % 3 == 2 ? 0.5 : at_a / (at_a - at_b));
        const Point<3> middle      = a + part * way;
        const double   value_there = value(middle);
        if (!std::isfinite(value_there))
          return {};
        if (value_there == 0)
          return middle;
        if ((value_there < 0) == (at_a < 0))
          {
            a    = middle;
            at_a = value_there;
          }
        else
          {
            b    = middle;
            at_b = value_there;
          }
      }
    // at a pole the sign changes, too, but the values grow as the interval
    // shrinks around it
    const bool at_pole = std::min(std::abs(at_a), std::abs(at_b)) > limit;
    if (at_pole)
      return {};
    return std::abs(at_a) < std::abs(at_b) ? a : b;
  }


  std::optional<Point<3>>
  FormulaSurface::surface_along_gradient(Point<3> x) const
  {
    double at_x = value(x);
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        // differences of low order will do: this is only a start for Newton's
        // method
        Tensor<1, 3> g;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Tensor<1, 3> way = step * Point<3>::unit_vector(i);
            g[i] = (value(x + way) - value(x - way)) / (2 * step);
          }
        Tensor<1, 3> move = -at_x / g.norm_square() * g;
        if (at_x == 0)
          return x;
        // the gradient may have vanished or overflown
        if (!std::isfinite(move.norm()) || move.norm() == 0)
          return {};
        Point<3> next    = x + move;
        double   at_next = value(next);
        for (unsigned int i = 0;
             i < 30 && !(std::abs(at_next) <= std::abs(at_x));
             ++i)
          {
            move /= 2;
            next    = x + move;
            at_next = value(next);
          }
        if (!(std::abs(at_next) <= std::abs(at_x)))
          return {};
        if ((at_next < 0) != (at_x < 0))
          return surface_between(x, next);
        if (move.norm() <= 1e-12 * size)
          return next;
        x    = next;
        at_x = at_next;
      }
    return {};
  }


  void
  FormulaSurface::search_closest(const Point<3> &x, const Search &search) const
  {
    Point<3>   closest     = search(surface_along_gradient(x).value_or(known));
    const bool is_inside   = (value(x) < 0);
    constexpr double inner = 0.999;
    // in the ball up to the closest point, all is on the side of its center;
    // false if a closer point has been found
    const auto is_on_this_side = [&](const Point<3> &y) {
      if ((value(y) < 0) == is_inside)
        return true;
      if (const auto start = surface_between(x, y))
        {
          const double before = x.distance_square(closest);
          closest             = search(*start);
          return !(x.distance_square(closest) < before);
        }
      return true;
    };
    // so close to the surface no other part of it is expected in between, since
    // no detail is smaller than the size
    if (x.distance(closest) < size / 10)
      return;
    // the surface may have been passed on the way
    is_on_this_side(x + inner * (closest - x));
    for (const double part : {inner, 0.5})
      for (const Tensor<1, 3> &direction : directions)
        is_on_this_side(x + part * x.distance(closest) * direction);

    // other hills beside the closest point
    bool found = true;
    for (unsigned int round = 0; found && round < 20; ++round)
      {
        found                  = false;
        const Tensor<1, 3> way = closest - x;
        // along the smallest component, for two directions beside it
        Tensor<1, 3> some;
        some[std::min_element(way.begin_raw(),
                              way.end_raw(),
                              [](const double a, const double b) {
                                return std::abs(a) < std::abs(b);
                              }) -
             way.begin_raw()]     = 1;
        const Tensor<1, 3> across = cross_product_3d(way, some),
                           along  = cross_product_3d(way, across);
        for (double beside = size; beside < way.norm() && !found; beside *= 2)
          for (unsigned int i = 0; i < 8; ++i)
            {
              const double       angle = i * numbers::PI / 4;
              const Tensor<1, 3> to =
                way + beside * (std::cos(angle) / across.norm() * across +
                                std::sin(angle) / along.norm() * along);
              const double part = inner * x.distance(closest) / to.norm();
              found             = !is_on_this_side(x + part * to) || found;
            }
      }
  }
} // namespace Biface
