// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_strip_h
#define biface_model_mesh_strip_h

#include <array>

#include <biface/laminate/laminate.h>

namespace Biface
{
  /** The plies of an element between two neighboring lines of the first
   * coordinate. */
  struct Strip
  {
    /** The laminate at the middle of the strip, which gives the stiffness of
     * the cells. */
    Laminate laminate;
    /** The laminates of the same plies at both lines of the strip. */
    std::array<Laminate, 2> at_lines;
  };
} // namespace Biface

#endif
