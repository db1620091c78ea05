// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/contact_conditions.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  using namespace dealii;

  void
  ContactConditions::Parameters::add_parameters(ParameterHandler &prm)
  {
    foundation.add_parameters(prm);
    add_choice(prm,
               "Multiplier mass",
               mass,
               {"consistent", "lumped"},
               "How nodal contact pressures act on the nodes: 'consistent' "
               "(the paper's; pressures oscillate at the edge of the contact "
               "zone) or 'lumped' (smooth, symmetric tangent).");
    prm.add_parameter("Regularization",
                      regularization,
                      "The parameter epsilon of the contact condition: a "
                      "pressure p penetrates by p/epsilon. Positive. Unit: "
                      "pressure/length.",
                      Patterns::Double());
  }


  void
  ContactConditions::Parameters::check() const
  {
    check_positive("Contact/Regularization", regularization);
    // which checks its parameters
    make_foundation(foundation);
  }
} // namespace Biface
