// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/input_error.h>
#include <biface/base/parameter_tools.h>
#include <biface/contact/contact_conditions.h>

namespace Biface
{
  using namespace dealii;

  void
  ContactConditions::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Plane normal",
                      normal,
                      "Normal of the rigid plane, from the shell toward the "
                      "foundation: three components x, y, z, of any length "
                      "but zero.");
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
    if (!(std::isfinite(normal.norm()) && normal.norm() > 0))
      throw InputError("Contact/Plane normal",
                       number_to_string(normal[0]) + ", " +
                         number_to_string(normal[1]) + ", " +
                         number_to_string(normal[2]),
                       "a normal must be finite and not the zero vector");
  }
} // namespace Biface
