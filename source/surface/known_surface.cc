// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/surface/known_surface.h>

namespace Biface
{
  using namespace dealii;

  Tensor<1, 3>
  SurfaceOfFormula::gradient(const Point<3> &x, const double size) const
  {
    Tensor<1, 3> result;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const Tensor<1, 3> way = step(size) * Point<3>::unit_vector(d);
        result[d] = (value(x + way) - value(x - way)) / (2 * step(size));
      }
    return result;
  }


  std::optional<Point<3>>
  SurfaceOfFormula::closest_point(const Point<3> &x, const double size) const
  {
    constexpr unsigned int n_iterations = 50;
    Point<3>               y            = x;
    double                 move         = 0;
    for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
      {
        const double       at_y   = value(y);
        const Tensor<1, 3> g      = gradient(y, size);
        const double       square = g.norm_square();
        if (!std::isfinite(at_y) || !std::isfinite(square) || !(square > 0))
          return {};
        if (iteration == 0 && std::abs(at_y) <= 1e-12 * size * g.norm())
          return y;
        // from x along the normal to the plane that is tangential at y
        const Point<3> next = x + (g * (y - x) - at_y) / square * g;
        move                = next.distance(y);
        y                   = next;
        if (move <= 1e-14 * size)
          return y;
      }
    // as far as the rounding of the formula lets it come
    return move <= 1e-9 * size ? std::optional<Point<3>>(y) : std::nullopt;
  }


  std::optional<Point<3>>
  SurfaceOfFormula::point_between(const Point<3>              &middle,
                                  const std::vector<Point<3>> &others,
                                  const double                 size) const
  {
    const auto found = closest_point(middle, size);
    if (!found)
      return {};
    // the other side of a wall has the opposite gradient
    const Tensor<1, 3> here = gradient(*found, size);
    for (const Point<3> &other : others)
      if (here * gradient(other, size) > 0)
        return found;
    return {};
  }


  Tensor<1, 3>
  SurfaceOfFormula::normal(const Point<3>     &x,
                           const Tensor<1, 3> &direction,
                           const double        size) const
  {
    const Tensor<1, 3> g = gradient(x, size);
    if (!(g.norm() > 0) || !std::isfinite(g.norm()))
      return {};
    // where one formula takes the place of another, both sides differ
    const double here = value(x);
    for (unsigned int d = 0; d < 3; ++d)
      {
        const Tensor<1, 3> way = step(size) * Point<3>::unit_vector(d);
        if (!(std::abs(value(x + way) + value(x - way) - 2 * here) <=
              1e-3 * step(size) * g.norm()))
          return {};
      }
    return (g * direction < 0 ? -1 : 1) / g.norm() * g;
  }
} // namespace Biface
