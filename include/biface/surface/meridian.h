// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_meridian_h
#define biface_surface_meridian_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <utility>

namespace Biface
{
  /**
   * A plane curve that generates a surface of revolution, given in the
   * half-plane (radius r, axial coordinate y) by a parameter s. The surface's
   * outward normal points to the right of the direction of growing s when r
   * points right and y up.
   */
  class Meridian
  {
  public:
    virtual ~Meridian() = default;

    /** Position and its first two derivatives with respect to s. */
    struct PointOfCurve
    {
      dealii::Point<2>     position;
      dealii::Tensor<1, 2> first_derivative;
      dealii::Tensor<1, 2> second_derivative;
    };

    /** The curve at the parameter @p s. */
    virtual PointOfCurve evaluate(const double s) const = 0;

    /** The parameter of a point on the curve. */
    virtual double parameter_of(const dealii::Point<2> &point) const = 0;

    /** See ReferenceSurface::coordinate_unit(). */
    virtual double coordinate_unit() const = 0;

    /**
     * The smallest distance from the axis (a negative one where the curve
     * crosses the axis) for parameters in [@p begin, @p end], and where.
     *
     * @return the pair (smallest radius, its parameter).
     */
    virtual std::pair<double, double>
    smallest_radius(const double begin, const double end) const = 0;
  };


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

      void add_parameters(dealii::ParameterHandler &prm);
    };

    /** Throws InputError where the radii are not those of an arc. */
    explicit CircularArc(const Parameters &parameters);

    PointOfCurve evaluate(const double s) const override;

    double parameter_of(const dealii::Point<2> &point) const override;

    double coordinate_unit() const override;

    std::pair<double, double> smallest_radius(const double begin,
                                              const double end) const override;

  private:
    const double radius;
    const double center_radius;
  };
} // namespace Biface

#endif
