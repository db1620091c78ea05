// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_named_points_h
#define biface_model_named_points_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include <biface/surface/reference_surface.h>

namespace Biface
{
  /** A point of the surface that has a name: nodes can be supported, loaded,
   * watched and steered by it. */
  struct NamedPoint
  {
    std::string name;
    /** In the surface's internal unit. */
    dealii::Point<2> alpha;
  };


  /** The points of a shell. */
  struct NamedPoints
  {
    std::string list;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Read the list in the units of @p surface. Throws InputError where it is
     * malformed, or names a point twice. */
    std::vector<NamedPoint>
    parse(const ReferenceSurface &surface) const;
  };
} // namespace Biface

#endif
