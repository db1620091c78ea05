// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_cord_equilibrium_h
#define biface_surface_cord_equilibrium_h

#include <array>
#include <optional>
#include <vector>

#include <biface/surface/meridian.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * The meridian of an inflated tire whose cords carry all of the pressure and
   * pantograph, @f$\cos\beta = \cos\beta_c\,r/r_c@f$ with the angle
   * @f$\beta@f$ from the circumference and the crown c @cite Purdy1963 : the
   * membrane forces @f$N_1 : N_2 = \tan^2\beta@f$ are in equilibrium with the
   * pressure if the normal has the radial component
   * @f[
   *   \sin\phi = \frac{(r^2 - r_w^2)\sin\beta}{(r_c^2 - r_w^2)\sin\beta_c},
   *   \qquad \frac{dr}{ds} = -\cos\phi, \quad \frac{dy}{ds} = \sin\phi,
   * @f]
   * with the radius @f$r_w@f$ of the widest point. With @f$\beta_c@f$ = 90
   * degrees it is that of a radial carcass.
   *
   * The parameter is the arc length from the crown, positive toward +y. The
   * curve is symmetric about y = 0, and smooth.
   */
  class CordEquilibrium : public Meridian
  {
  public:
    struct Parameters
    {
      double crown_radius = 250;
      double half_width   = 50;
      double end_radius   = 180;
      /** The angle @f$\beta_c@f$ of the cords at the crown from the
       * circumference, in degrees; not set if it follows from the half width at
       * the end. */
      std::optional<double> crown_cord_angle = 38;
      /** The half width at the end; not set if it follows from the angle. */
      std::optional<double> end_half_width;

      void
      add_parameters(EntryDeclarations &prm);
    };

    /** Compute the curve. Throws InputError if there is none for these
     * parameters. */
    explicit CordEquilibrium(const Parameters &parameters);

    PointOfCurve
    evaluate(const double s) const override;

    double
    parameter_of(const dealii::Point<2> &point) const override;

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit() const override
    {
      return 1;
    }

    std::optional<double>
    crown_cord_angle() const override;

    /** The radius @f$r_w@f$ of the widest point. */
    double
    widest_radius() const
    {
      return shape.widest_radius;
    }

    /** The numbers that determine the curve. */
    struct Shape
    {
      double crown_radius;
      double widest_radius;
      /** The angle @f$\beta_c@f$ of the cords at the crown, in radians. */
      double crown_cord_angle;

      /** The value @f$1 - \sin\phi@f$ at the distance @p depth below the crown
       * radius, without cancellation. */
      double
      one_minus_sine(const double depth) const;

      /** The derivative @f$d\sin\phi/dr@f$, the curvature of the meridian. */
      double
      curvature(const double r) const;

      /** The half width at the radius @p r. NaN if the curve does not reach
       * this radius. */
      double
      half_width(const double r) const;
    };

  private:
    /** The position (r, y) of a point of the curve and the angle @f$\phi@f$ of
     * its normal. */
    using Position = std::array<double, 3>;

    /** The position at the distance @p length along the curve from another. */
    Position
    advance(const Position &position, const double length) const;

    Shape  shape;
    double length;
    /** The positions at equal distances from the crown to the end. */
    std::vector<Position> samples;
  };
} // namespace Biface

#endif
