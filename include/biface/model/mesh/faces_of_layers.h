// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_faces_of_layers_h
#define biface_model_mesh_faces_of_layers_h

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <biface/laminate/laminate.h>

namespace Biface
{
  class Layup;
  struct PlyPlace;
  struct Strip;

  /** The wall of a shell at a place. */
  struct WallAtPlace
  {
    /** Lay up the plies at a place, see Layup::layers(). */
    WallAtPlace(const Layup &layup, const PlyPlace &place, const double within);

    Laminate                             wall;
    std::vector<std::optional<Laminate>> layers;
    /** The heights of all faces, see heights_of_faces(). Unit: length. */
    std::vector<double> heights;
  };

  /** The walls at the vertices of a cell. */
  using WallsAtVertices = std::array<std::shared_ptr<const WallAtPlace>, 4>;

  /** The heights of the faces of the layers of a wall, inner face first. A
   * layer without plies has no thickness. Unit: length.
   * @param wall the heights of its inner and outer face. */
  std::vector<double>
  heights_of_faces(const std::array<double, 2>                &wall,
                   const std::vector<std::optional<Laminate>> &layers);

  /** The strip of a whole wall.
   * @param inside the wall in the middle. */
  Strip
  strip_of_wall(const WallAtPlace &inside, const WallsAtVertices &at_vertices);

  /** The positions among strips of the layers of a wall: its own position if it
   * has one layer, otherwise those of layers that are appended, and an invalid
   * number for layers that do not exist.
   * @param wall the position of the wall. */
  std::vector<unsigned int>
  append_layers(const unsigned int     wall,
                const WallAtPlace     &inside,
                const WallsAtVertices &at_vertices,
                std::vector<Strip>    &strips);

  /** The number of elements of a cell with these layers: the wall and, if there
   * are several, those that exist. */
  unsigned int
  n_elements_of(const std::vector<std::optional<Laminate>> &layers);

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
