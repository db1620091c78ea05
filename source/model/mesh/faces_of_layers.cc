// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/types.h>

#include <algorithm>

#include <biface/laminate/layup.h>
#include <biface/model/mesh/faces_of_layers.h>
#include <biface/model/mesh/strip.h>

namespace Biface
{
  using namespace dealii;

  std::vector<double>
  heights_of_faces(const std::array<double, 2>                &wall,
                   const std::vector<std::optional<Laminate>> &layers)
  {
    unsigned int last = 0;
    for (unsigned int k = 0; k < layers.size(); ++k)
      if (layers[k])
        last = k;
    std::vector<double> heights{wall[0]};
    for (unsigned int k = 0; k < layers.size(); ++k)
      heights.push_back(
        // the outer face exactly, not up to the round-off of the sum
        k >= last ? wall[1]
                  : heights.back() + (layers[k] ? layers[k]->thickness() : 0.));
    return heights;
  }


  WallAtPlace::WallAtPlace(const Layup    &layup,
                           const PlyPlace &place,
                           const double    within)
    : wall(layup.laminate(place, within))
    , layers(layup.n_layers() > 1 ? layup.layers(place, within)
                                  : std::vector<std::optional<Laminate>>{wall})
    , heights(heights_of_faces(wall.face_heights(), layers))
  {}


  namespace
  {
    /** The laminates of a member of the walls at the vertices. */
    template <typename Member>
    std::array<std::shared_ptr<const Laminate>, 4>
    at_vertices(const WallsAtVertices &walls, const Member &member)
    {
      std::array<std::shared_ptr<const Laminate>, 4> result;
      for (unsigned int v = 0; v < 4; ++v)
        // of the same wall, which lives as long as any part of it
        result[v] = {walls[v], &member(*walls[v])};
      return result;
    }
  } // namespace


  Strip
  strip_of_wall(const WallAtPlace &inside, const WallsAtVertices &walls)
  {
    return {inside.wall,
            at_vertices(walls, [](const WallAtPlace &at) -> const Laminate & {
              return at.wall;
            })};
  }


  std::vector<unsigned int>
  append_layers(const unsigned int     wall,
                const WallAtPlace     &inside,
                const WallsAtVertices &walls,
                std::vector<Strip>    &strips)
  {
    if (inside.layers.size() == 1)
      return {wall};
    std::vector<unsigned int> positions;
    for (unsigned int k = 0; k < inside.layers.size(); ++k)
      if (inside.layers[k])
        {
          positions.push_back(strips.size());
          strips.push_back(
            {*inside.layers[k],
             at_vertices(walls, [k](const WallAtPlace &at) -> const Laminate & {
               return *at.layers[k];
             })});
        }
      else
        // a layer has no elements where its plies have ended
        positions.push_back(numbers::invalid_unsigned_int);
    return positions;
  }


  unsigned int
  n_elements_of(const std::vector<std::optional<Laminate>> &layers)
  {
    return (layers.size() > 1 ? 1 : 0) +
           std::count_if(layers.begin(), layers.end(), [](const auto &layer) {
             return layer.has_value();
           });
  }


  unsigned int
  stiffest_layer(const std::vector<double> &stiffness)
  {
    const double largest =
      *std::max_element(stiffness.begin(), stiffness.end());
    if (!(largest > 0))
      return numbers::invalid_unsigned_int;
    // of equal layers always the innermost, whatever round-off says
    return std::find_if(stiffness.begin(),
                        stiffness.end(),
                        [largest](const double value) {
                          return value >= 0.99 * largest;
                        }) -
           stiffness.begin();
  }
} // namespace Biface
