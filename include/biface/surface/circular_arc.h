// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_circular_arc_h
#define biface_surface_circular_arc_h

#include <biface/surface/meridian.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * A circular arc, @f$r = r_c + R_1\cos s@f$, @f$y = R_1\sin s@f$: it
   * generates a torus (@f$r_c > 0@f$) or a sphere (@f$r_c = 0@f$). The
   * parameter is the angle @f$\psi@f$ from the equator, in radians.
   */
  class CircularArc : public Meridian
  {
  public:
    struct Parameters
    {
      double radius        = 50;
      double center_radius = 200;

      void
      add_parameters(EntryDeclarations &prm);
    };

    /** Throws InputError if the radii are invalid. */
    explicit CircularArc(const Parameters &parameters);

    PointOfCurve
    evaluate(const double s) const override;

    double
    parameter_of(const dealii::Point<2> &point) const override;

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit() const override;

  private:
    const double radius;
    const double center_radius;
  };
} // namespace Biface

#endif
