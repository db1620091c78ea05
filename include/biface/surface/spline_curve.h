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
   * and zero at both ends. The parameter is this length from the first point;
   * it is close to the arc length if the points are dense.
   */
  class SplineCurve : public Meridian
  {
  public:
    /**
     * Throws InputError if there are fewer than 3 points, or if a point is not
     * finite, repeats the previous one, does not have a positive radius, or
     * turns the curve back, or if the curve crosses itself.
     *
     * @param points (r, y), in order along the curve.
     * @param name the name of their file, for error messages.
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
    /** The parameters and positions of a few points per interval, where
     * parameter_of() starts. */
    std::vector<std::pair<double, dealii::Point<2>>> samples;
    std::unique_ptr<dealii::Functions::CSpline<1>>   radius;
    std::unique_ptr<dealii::Functions::CSpline<1>>   axial;
  };

} // namespace Biface

#endif
