// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/model/mesh/plies_on_surface.h>

#include <boost/math/tools/minima.hpp>

namespace Biface
{
  using namespace dealii;

  SurfaceOfPlies
  plies_on_surface(const std::shared_ptr<const ReferenceSurface> &surface,
                   const ChartGrid                               &grid)
  {
    SurfaceOfPlies plies;
    if (!surface->has_chart())
      return plies;
    plies.end              = surface->end(0);
    plies.crown_cord_angle = surface->crown_cord_angle();
    plies.curvature        = [surface](const double alpha_1) {
      const double unit = surface->coordinate_unit(0);
      return surface->evaluate(Point<2>(alpha_1 * unit, 0)).curvature;
    };
    // only a surface of revolution has a radius and a crown
    if (surface->axis().norm() == 0)
      return plies;

    const double unit = surface->coordinate_unit(0);
    plies.radius      = [surface, unit](const double alpha_1) {
      const Point<3> x =
        surface->evaluate(Point<2>(alpha_1 * unit, 0)).position;
      return (x - (x * surface->axis()) * surface->axis()).norm();
    };

    const std::vector<double> &lines = grid.lines[0];
    const auto                 less  = [&](const double a, const double b) {
      return plies.radius(a / unit) < plies.radius(b / unit);
    };
    const auto highest = std::max_element(lines.begin(), lines.end(), less);
    plies.crown        = *highest / unit;
    // the crown may lie between two lines
    const auto between = boost::math::tools::brent_find_minima(
      [&](const double alpha_1) { return -plies.radius(alpha_1); },
      (highest == lines.begin() ? *highest : highest[-1]) / unit,
      (highest + 1 == lines.end() ? *highest : highest[1]) / unit,
      26);
    if (-between.second > plies.radius(plies.crown) * (1 + 1e-12))
      plies.crown = between.first;
    return plies;
  }
} // namespace Biface
