// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_straight_line_h
#define biface_surface_straight_line_h

#include <biface/surface/meridian.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * A straight line: it generates a cylinder, a cone, or a flat annulus. The
   * parameter is the length from its start.
   */
  class StraightLine : public Meridian
  {
  public:
    struct Parameters
    {
      /** The ends of the line as (r, y). */
      dealii::Point<2> start = dealii::Point<2>(1, 0);
      dealii::Point<2> end   = dealii::Point<2>(1, 1);

      void
      add_parameters(EntryDeclarations &prm);
    };

    /** Throws InputError if the ends coincide or lie beyond the axis. */
    explicit StraightLine(const Parameters &parameters);

    PointOfCurve
    evaluate(const double s) const override;

    double
    parameter_of(const dealii::Point<2> &point) const override;

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit() const override;

  private:
    const dealii::Point<2>     start;
    const dealii::Tensor<1, 2> direction;
    const double               length;
  };
} // namespace Biface

#endif
