// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_spline_curve_h
#define biface_surface_spline_curve_h

#include <deal.II/base/function_cspline.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <biface/surface/meridian.h>

namespace Biface
{
  /**
   * A smooth curve through given points: a cubic spline in each coordinate over
   * the length of the polygon through the points. Its curvature is continuous,
   * and zero at both ends. The parameter is that length from the first point,
   * which is close to the arc length where the points are dense.
   */
  class SplineCurve : public Meridian
  {
  public:
    /**
     * Throws InputError where there are less than 3 points, where a point is
     * not finite, repeats the one before it, or does not have a positive
     * radius.
     *
     * @param points (r, y), in order along the curve.
     * @param name of the file they come from, for error messages.
     */
    SplineCurve(const std::vector<dealii::Point<2>> &points,
                const std::string                   &name);

    PointOfCurve
    evaluate(const double s) const override;

    double
    parameter_of(const dealii::Point<2> &point) const override;

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit() const override;

    /** The parameter of the last point. */
    double
    length() const
    {
      return knots.back();
    }

  private:
    std::vector<double> knots;
    /** Parameters and positions of a few points an interval. */
    std::vector<std::pair<double, dealii::Point<2>>> samples;
    std::unique_ptr<dealii::Functions::CSpline<1>>   radius;
    std::unique_ptr<dealii::Functions::CSpline<1>>   axial;
  };

} // namespace Biface

#endif
