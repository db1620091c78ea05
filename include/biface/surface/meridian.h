// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_meridian_h
#define biface_surface_meridian_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <utility>
#include <vector>

namespace Biface
{
  /** A rounded corner of a meridian. */
  struct RoundedCorner
  {
    /** The parameter in the middle of the corner. */
    double s;
    /** The least radius of curvature, positive where the curve turns to the
     * left, away from the outward normal. Unit: length. */
    double radius;
  };


  /**
   * A plane curve that generates a surface of revolution, given in the
   * half-plane (radius r, axial coordinate y) as a function of a parameter s.
   * The outward normal of the surface points to the right of the direction of
   * increasing s when r points right and y up.
   */
  class Meridian
  {
  public:
    virtual ~Meridian() = default;

    /** A position and its first two derivatives with respect to s. */
    struct PointOfCurve
    {
      dealii::Point<2>     position;
      dealii::Tensor<1, 2> first_derivative;
      dealii::Tensor<1, 2> second_derivative;
    };

    /** The curve at the parameter @p s. */
    virtual PointOfCurve
    evaluate(const double s) const = 0;

    /** The parameter of a point on the curve. */
    virtual double
    parameter_of(const dealii::Point<2> &point) const = 0;

    /** The minimum and maximum parameter, between which parameter_of() is the
     * inverse of evaluate(). */
    virtual std::pair<double, double>
    range() const = 0;

    /** The factor from the user's unit of the parameter to the internal one,
     * see ReferenceSurface::coordinate_unit(). */
    virtual double
    coordinate_unit() const = 0;

    /** The rounded corners, which may be shorter than the cells of a mesh. */
    virtual std::vector<RoundedCorner>
    get_corners() const
    {
      return {};
    }

    /** The angle of the cords at the crown of a curve that is in equilibrium
     * with their tension, in degrees, see
     * ReferenceSurface::crown_cord_angle(). */
    virtual std::optional<double>
    crown_cord_angle() const
    {
      return {};
    }
  };
} // namespace Biface

#endif
