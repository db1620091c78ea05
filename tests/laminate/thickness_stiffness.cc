// SPDX-License-Identifier: LGPL-2.1-or-later

// Across the thickness the plies are springs in series, with their Young's
// moduli in this direction.

#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>

#include <cord_ply.h>
#include <tests.h>

using namespace Biface;

namespace
{
  double
  stiffness(const std::string &plies)
  {
    auto               materials = cord_ply();
    MaterialParameters rubber;
    rubber.name = "rubber";
    rubber.E    = 5;
    rubber.nu   = 0.49;
    materials.push_back(rubber);
    Layup::Parameters parameters;
    parameters.plies = parse_plies("plies", plies);
    return Layup(parameters, materials).laminate(0).thickness_stiffness();
  }
} // namespace


int
main()
{
  const double tire = stiffness(
    "cord: 1.2 @ 52, cord: 1.2 @ -52, cord: 1.2 @ 52, cord: 1.2 @ -52");
  check_small("bias tire", tire - 6.91 / 4.8, 1e-12);
  check_small("cords and rubber",
              stiffness("rubber: 2 @ 0, cord: 1.2 @ 30") -
                1 / (2 / 5. + 1.2 / 6.91),
              1e-12);
  // what the default of Contact/Regularization is a multiple of
  check_small("7000 times that of the bias tire beside 1e4 MPa/mm",
              7000 * tire - 1e4,
              0.01,
              1e4);
}
