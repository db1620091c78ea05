// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/strain_sampling.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  void
  ElementParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Strain sampling",
      sampling,
      {"vertices", "means"},
      "Where the element takes its strains from. 'means', from its four "
      "vertices, but with the quadratic terms of the constant strains "
      "as means over the element and with two modes of twist: it does "
      "not buckle from node to node where the shell "
      "is compressed. 'vertices', from the vertices alone, is the "
      "element of Grigolyuk, Kulikov and Plotnikova (2004).");
  }
} // namespace Biface
