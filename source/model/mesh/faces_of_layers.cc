// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/types.h>

#include <algorithm>

#include <biface/laminate/laminate.h>
#include <biface/model/mesh/faces_of_layers.h>

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
