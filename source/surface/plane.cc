// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/surface/plane.h>

namespace Biface
{
  using namespace dealii;

  SurfacePoint
  Plane::evaluate(const Point<2> &alpha) const
  {
    SurfacePoint point;
    point.position  = Point<3>(alpha[0], alpha[1], 0);
    point.lame      = {{1, 1}};
    point.curvature = {{0, 0}};
    point.geodesic  = {{0, 0}};
    for (unsigned int i = 0; i < 3; ++i)
      point.frame[i][i] = 1;
    return point;
  }


  Point<2>
  Plane::pull_back(const Point<3> &point) const
  {
    return Point<2>(point[0], point[1]);
  }


  std::unique_ptr<Manifold<2, 3>>
  Plane::clone() const
  {
    return std::make_unique<Plane>();
  }


  std::pair<double, double>
  Plane::range() const
  {
    return {std::numeric_limits<double>::lowest(),
            std::numeric_limits<double>::max()};
  }


  double
  Plane::coordinate_unit(const unsigned int) const
  {
    return 1;
  }
} // namespace Biface
