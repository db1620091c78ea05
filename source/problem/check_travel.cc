// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <biface/contact/rigid_body.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Whether a support of an edge is more than a symmetry, and does not
     * move. */
    bool
    is_held(const std::vector<SupportCondition> &support)
    {
      std::set<Component> held;
      for (const SupportCondition &condition : support)
        if (condition.value != 0 || condition.formula)
          return false;
        else
          held.insert(condition.component);
      return held.size() > 1;
    }
  } // namespace


  std::string
  Parameters::travel_beyond_supports() const
  {
    const auto beyond = [&](const double limit) {
      return std::find_if(
        stages.begin(), stages.end(), [&](const Stage &stage) {
          return stage.contact && stage.travel.value_or(0) > limit;
        });
    };
    if (beyond(0) == stages.end())
      return {};

    const std::unique_ptr<const ReferenceSurface> made = make_surface(surface);
    const ChartGrid                               grid(mesh, *made);
    const RigidBody                               ground(contact.body);
    constexpr double      infinity = std::numeric_limits<double>::infinity();
    double                first    = infinity;
    std::array<double, 4> to_edge;
    to_edge.fill(infinity);
    for (unsigned int j = 0; j < grid.n_nodes(1); ++j)
      for (unsigned int i = 0; i < grid.n_nodes(0); ++i)
        {
          const double travel =
            ground.travel_to(made->push_forward(grid.alpha({{i, j}})));
          first = std::min(first, travel);
          const std::array<bool, 4> on_edge{{i == 0,
                                             i + 1 == grid.n_nodes(0),
                                             j == 0,
                                             j + 1 == grid.n_nodes(1)}};
          for (unsigned int e = 0; e < 4; ++e)
            if (on_edge[e] && is_held(supports.edges[e]))
              to_edge[e] = std::min(to_edge[e], travel);
        }
    const auto   nearest = std::min_element(to_edge.begin(), to_edge.end());
    const double height  = *nearest - first;
    const auto   stage   = beyond(height);
    // at the edge itself, pierced nodes are reported
    if (!(height > 1e-6 * std::abs(*nearest)) || stage == stages.end())
      return {};
    return "Warning: in stage " + std::to_string(stage - stages.begin() + 1) +
           " the ground travels by " + number_to_string(*stage->travel) +
           ", but the supported edge of " +
           edge_names[nearest - to_edge.begin()] + " is only " +
           number_to_string(height) +
           " behind the point of the undeformed shell that it touches first.";
  }
} // namespace Biface
