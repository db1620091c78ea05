// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_faces_of_layers_h
#define biface_model_mesh_faces_of_layers_h

#include <array>
#include <optional>
#include <vector>

namespace Biface
{
  class Laminate;

  /** The heights of the faces of the layers of a wall, inner face first. A
   * layer without plies has no thickness. Unit: length.
   * @param wall the heights of its inner and outer face. */
  std::vector<double>
  heights_of_faces(const std::array<double, 2>                &wall,
                   const std::vector<std::optional<Laminate>> &layers);

  /** The layer that goes on at its own height where plies end, so that stiff
   * layers stay connected whatever a soft one does, section 4 of doc/theory.md:
   * that with the largest stiffness. Of those that differ by less than a
   * percent, the innermost one; an invalid number if none goes on.
   * @param stiffness of the layers in the surface; 0 for those that do not go
   * on. */
  unsigned int
  stiffest_layer(const std::vector<double> &stiffness);
} // namespace Biface

#endif
