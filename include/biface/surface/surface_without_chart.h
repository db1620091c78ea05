// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_surface_without_chart_h
#define biface_surface_surface_without_chart_h

#include <deal.II/base/exceptions.h>

#include <limits>
#include <memory>

#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** The surface of a mesh that has no coordinates, see QuadrilateralMesh: it
   * has points, normals and groups, but no lines along which to measure, and no
   * axis. */
  class SurfaceWithoutChart : public ReferenceSurface
  {
  public:
    SurfacePoint
    evaluate(const dealii::Point<2> &) const override
    {
      Assert(false, dealii::ExcMessage("The surface has no coordinates."));
      return {};
    }

    dealii::Point<2>
    pull_back(const dealii::Point<3> &) const override
    {
      Assert(false, dealii::ExcMessage("The surface has no coordinates."));
      return {};
    }

    std::unique_ptr<dealii::Manifold<2, 3>>
    clone() const override
    {
      return std::make_unique<SurfaceWithoutChart>();
    }

    bool
    has_chart() const override
    {
      return false;
    }

    std::pair<double, double>
    range() const override
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      return {-infinity, infinity};
    }

    double
    coordinate_unit(const unsigned int) const override
    {
      return 1;
    }
  };
} // namespace Biface

#endif
