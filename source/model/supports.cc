// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/parameter_tools.h>
#include <biface/model/supports.h>

namespace Biface
{
  void
  Supports::add_parameters(dealii::ParameterHandler &prm)
  {
    const std::array<std::string, 4> names{
      {"alpha_1 min", "alpha_1 max", "alpha_2 min", "alpha_2 max"}};
    for (unsigned int edge = 0; edge < 4; ++edge)
      add_choice(prm,
                 names[edge],
                 edges[edge],
                 {"free", "fixed", "symmetry"},
                 "What holds the edge " + names[edge] +
                   ": nothing, no displacement of either face ('fixed'), or "
                   "no displacement across the edge ('symmetry'). An edge of a "
                   "closed coordinate does not exist and stays 'free'.");
  }
} // namespace Biface
