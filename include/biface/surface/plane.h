// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_plane_h
#define biface_surface_plane_h

#include <memory>

#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** The plane z = 0 with @f$\alpha_1 = x@f$, @f$\alpha_2 = y@f$, and the
   * outward normal along z. */
  class Plane : public ReferenceSurface
  {
  public:
    SurfacePoint
    evaluate(const dealii::Point<2> &alpha) const override;

    dealii::Point<2>
    pull_back(const dealii::Point<3> &point) const override;

    std::unique_ptr<dealii::Manifold<2, 3>>
    clone() const override;

    std::pair<double, double>
    range() const override;

    double
    coordinate_unit(const unsigned int a) const override;
  };
} // namespace Biface

#endif
