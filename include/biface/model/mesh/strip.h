// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_strip_h
#define biface_model_mesh_strip_h

#include <array>
#include <memory>

#include <biface/laminate/laminate.h>

namespace Biface
{
  /** The plies of elements: of those between two neighboring lines of the
   * first coordinate, or on a mesh from a file of those in the same groups of
   * cells, or of a single one if plies vary there. */
  struct Strip
  {
    /** The laminate at the middle, which gives the stiffness of the cells. */
    Laminate laminate;
    /** The laminates of the same plies at the vertices of a cell. */
    std::array<std::shared_ptr<const Laminate>, 4> at_vertices;
  };
} // namespace Biface

#endif
