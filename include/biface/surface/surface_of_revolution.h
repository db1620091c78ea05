// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_surface_of_revolution_h
#define biface_surface_surface_of_revolution_h

#include <memory>
#include <vector>

#include <biface/surface/meridian.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  /**
   * A meridian rotated about the y axis:
   * @f$\mathbf x = (r\cos\varphi,\; y,\; r\sin\varphi)@f$ with @f$(r,y)@f$ on
   * the meridian at @f$\alpha_1@f$ and @f$\varphi = \alpha_2@f$ in radians.
   *
   * The y axis is the axle of a wheel. The frame @f$\mathbf e_1@f$ (along the
   * meridian), @f$\mathbf e_2@f$ (around the axis), @f$\mathbf e_3@f$ (outward)
   * is right-handed. In terms of the meridian, @f$A_1 = |(r',y')|@f$,
   * @f$A_2 = r@f$, @f$k_1 = (r'y''-y'r'')/A_1^3@f$, @f$k_2 = y'/(A_1 r)@f$,
   * @f$B_1 = r'/(A_1 r)@f$, @f$B_2 = 0@f$.
   *
   * A torus is the surface of a CircularArc.
   */
  class SurfaceOfRevolution : public ReferenceSurface
  {
  public:
    explicit SurfaceOfRevolution(std::shared_ptr<const Meridian> meridian);

    SurfacePoint
    evaluate(const dealii::Point<2> &alpha) const override;

    dealii::Point<2>
    pull_back(const dealii::Point<3> &point) const override;

    std::unique_ptr<dealii::Manifold<2, 3>>
    clone() const override;

    /** The unit vector along the y axis. */
    dealii::Tensor<1, 3>
    axis() const override
    {
      return dealii::Tensor<1, 3>({0, 1, 0});
    }

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit(const unsigned int a) const override;

    std::vector<RoundedCorner>
    get_corners() const override
    {
      return meridian->get_corners();
    }

    std::optional<double>
    crown_cord_angle() const override
    {
      return meridian->crown_cord_angle();
    }

  private:
    std::shared_ptr<const Meridian> meridian;
  };
} // namespace Biface

#endif
