// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_spline_curve_h
#define biface_surface_spline_curve_h

#include <deal.II/base/function_cspline.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <biface/surface/contour.h>
#include <biface/surface/meridian.h>

namespace Biface
{
  /**
   * A smooth curve through given points: a cubic spline in each coordinate over
   * the length of the polygon through the points. Its curvature is continuous,
   * and zero at both ends. The parameter is this length from the first point;
   * it is close to the arc length if the points are dense. Points that only
   * repeat their neighbors are left out, see Contour.
   *
   * With a corner radius, each kink of the points ends one spline and begins
   * another one, and a polynomial of fifth degree with the same position, first
   * and second derivative at its ends rounds the corner between them.
   */
  class SplineCurve : public Meridian
  {
  public:
    /** The curve that rounds a corner. */
    struct Rounding
    {
      /** Where the rounding begins and ends. */
      double begin, end;
      /** The coefficients of the powers of a polynomial of the fifth degree
       * over the fraction of the way from begin to end. Unit: length. */
      std::array<dealii::Tensor<1, 2>, 6> coefficients;
    };

    /**
     * Throws InputError if there are fewer than 3 points, or if a point is not
     * finite, repeats the previous one, does not have a positive radius, or
     * turns the curve back, if a corner has no room, or if the curve crosses
     * itself.
     *
     * @param points (r, y), in order along the curve.
     * @param name the name of their file, for error messages.
     * @param corner_radius the least radius of curvature of a corner between
     * straight lines; 0 for a spline through all points.
     */
    SplineCurve(const std::vector<dealii::Point<2>> &points,
                const std::string                   &name,
                const double                         corner_radius = 0);

    PointOfCurve
    evaluate(const double s) const override;

    double
    parameter_of(const dealii::Point<2> &point) const override;

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit() const override;

    std::vector<RoundedCorner>
    get_corners() const override
    {
      return corners;
    }

    /** The parameter of the last point. */
    double
    length() const
    {
      return knots.back();
    }

    /** Sentences on how the points were read: those taken as one, and kinks. */
    const std::vector<std::string> &
    get_remarks() const
    {
      return remarks;
    }

  private:
    /** The spline between two ends or corners. */
    struct Part
    {
      double                                         begin, end;
      std::shared_ptr<dealii::Functions::CSpline<1>> radius;
      std::shared_ptr<dealii::Functions::CSpline<1>> axial;

      PointOfCurve
      evaluate(const double s) const;
    };

    /** Throws InputError where points cannot be those of a meridian. */
    void
    set_knots(const Contour &contour, const std::string &name);

    /** The spline through the points from @p first to @p last. */
    Part
    make_part(const std::vector<dealii::Point<2>> &points,
              const unsigned int                   first,
              const unsigned int                   last) const;

    void
    round_corners(const Contour     &contour,
                  const std::string &name,
                  const double       corner_radius);

    /** Throws InputError if the curve crosses itself. */
    void
    check_crossing(const Contour &contour, const std::string &name);

    /** The parameter of the sample nearest to a point. */
    double
    nearest_sample(const dealii::Point<2> &point) const;

    std::vector<double> knots;
    /** The parameters and positions of a few points per interval, where
     * parameter_of() starts, in the order of the parameters. */
    std::vector<std::pair<double, dealii::Point<2>>> samples;
    /** The largest distance between neighboring samples. */
    double            largest_step = 0;
    std::vector<Part> parts;
    /** Between each part and the next one. */
    std::vector<Rounding> roundings;
    /** What the roundings make of each kink. */
    std::vector<RoundedCorner> corners;
    std::vector<std::string>   remarks;
  };

} // namespace Biface

#endif
