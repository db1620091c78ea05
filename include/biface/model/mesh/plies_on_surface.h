// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_plies_on_surface_h
#define biface_model_mesh_plies_on_surface_h

#include <memory>

#include <biface/laminate/surface_of_plies.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** The surface as plies know it, with the crown of the part covered by a
   * grid. */
  SurfaceOfPlies
  plies_on_surface(const std::shared_ptr<const ReferenceSurface> &surface,
                   const ChartGrid                               &grid);
} // namespace Biface

#endif
