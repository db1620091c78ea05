// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/surface/surface_of_revolution.h>

namespace Biface
{
  using namespace dealii;

  SurfaceOfRevolution::SurfaceOfRevolution(
    std::shared_ptr<const Meridian> meridian)
    : ReferenceSurface(Tensor<1, 2>({0., 2 * numbers::PI}))
    , meridian(std::move(meridian))
  {}


  SurfacePoint
  SurfaceOfRevolution::evaluate(const Point<2> &alpha) const
  {
    const Meridian::PointOfCurve curve  = meridian->evaluate(alpha[0]);
    const double                 r      = curve.position[0];
    const Tensor<1, 2>          &d      = curve.first_derivative;
    const Tensor<1, 2>          &dd     = curve.second_derivative;
    const double                 A_1    = d.norm();
    const double                 cosine = std::cos(alpha[1]);
    const double                 sine   = std::sin(alpha[1]);

    // the normal points to the right of the meridian, and curvatures are
    // positive where it points away from their centers, section 1
    SurfacePoint point;
    point.position  = Point<3>(r * cosine, curve.position[1], r * sine);
    point.frame[0]  = Tensor<1, 3>({d[0] * cosine, d[1], d[0] * sine}) / A_1;
    point.frame[1]  = Tensor<1, 3>({-sine, 0, cosine});
    point.frame[2]  = Tensor<1, 3>({d[1] * cosine, -d[0], d[1] * sine}) / A_1;
    point.lame      = {{A_1, r}};
    point.curvature = {
      {(d[0] * dd[1] - d[1] * dd[0]) / (A_1 * A_1 * A_1), d[1] / (A_1 * r)}};
    point.geodesic = {{d[0] / (A_1 * r), 0}};
    return point;
  }


  Point<2>
  SurfaceOfRevolution::pull_back(const Point<3> &point) const
  {
    const double r = std::hypot(point[0], point[2]);
    return Point<2>(meridian->parameter_of(Point<2>(r, point[1])),
                    std::atan2(point[2], point[0]));
  }


  std::unique_ptr<Manifold<2, 3>>
  SurfaceOfRevolution::clone() const
  {
    return std::make_unique<SurfaceOfRevolution>(meridian);
  }


  std::pair<double, double>
  SurfaceOfRevolution::range() const
  {
    return meridian->range();
  }


  double
  SurfaceOfRevolution::coordinate_unit(const unsigned int a) const
  {
    return a == 0 ? meridian->coordinate_unit() : numbers::PI / 180;
  }
} // namespace Biface
