// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/model/mesh/contributions_of_layers.h>

namespace Biface
{
  std::vector<Cell::Contribution>
  contributions_to_wall(const Node &node, const std::array<double, 2> &own)
  {
    const double       inner     = node.face_heights[0];
    const double       outer     = node.face_heights[1];
    const double       thickness = outer - inner;
    Cell::Contribution part;
    if (own[0] != inner || own[1] != outer)
      {
        // s and r of section 2 of doc/theory.md: displacements are linear
        // over the wall, and beyond its faces at the node
        part.mean            = (own[1] + own[0] - outer - inner) / thickness;
        part.half_difference = (own[1] - own[0]) / thickness;
      }
    return std::vector<Cell::Contribution>(node.n_layers(), part);
  }


  std::vector<Cell::Contribution>
  contributions_to_layer(const Node                &node,
                         const std::vector<double> &own,
                         const unsigned int         stiffest,
                         const unsigned int         layer)
  {
    const unsigned int n_layers = node.n_layers();
    const auto         ratio    = [&](const unsigned int k) {
      return (own[k + 1] - own[k]) / (2 * node.half_thickness[k]);
    };

    // the displacement of the middle of the stiffest layer
    std::vector<Cell::Contribution> result(n_layers, {0, 0});
    for (unsigned int k = 0; k < n_layers; ++k)
      result[k].mean = (k < stiffest ? 1 : -1);
    result[stiffest].mean = (own[stiffest] - node.height(stiffest) +
                             own[stiffest + 1] - node.height(stiffest + 1)) /
                            (2 * node.half_thickness[stiffest]);

    // from there to the middle of this one
    if (layer != stiffest)
      for (unsigned int k = std::min(layer, stiffest);
           k <= std::max(layer, stiffest);
           ++k)
        if (node.half_thickness[k] > 0)
          result[k].mean += (layer > stiffest ? 1 : -1) *
                            (k == layer || k == stiffest ? 1 : 2) * ratio(k);
    result[layer].half_difference = ratio(layer);
    return result;
  }
} // namespace Biface
