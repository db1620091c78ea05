// SPDX-License-Identifier: LGPL-2.1-or-later

// The mass moments of a laminate are the integrals of the density of its plies
// with the products of the shape functions of the faces.

#include <biface/laminate/layup.h>

#include <cord_ply.h>
#include <tests.h>

using namespace Biface;

namespace
{
  void
  test(const std::string &plies,
       const double       inner,
       const double       mixed,
       const double       outer)
  {
    auto materials       = cord_ply();
    materials[0].density = 2;
    materials.push_back(materials[0]);
    materials[1].name    = "heavy";
    materials[1].density = 6;
    Layup::Parameters parameters;
    parameters.plies = parse_plies("plies", plies);
    const auto m     = Layup(parameters, materials).laminate(0).mass_moments();
    std::cout << plies << std::endl;
    check_small("  inner", m[0][0] - inner, 1e-13);
    check_small("  mixed", m[0][1] - mixed, 1e-13);
    check_small("  symmetric", m[0][1] - m[1][0], 1e-15);
    check_small("  outer", m[1][1] - outer, 1e-13);
  }
} // namespace


int
main()
{
  // density times h times 1/3, 1/6, 1/3
  test("cord: 3 @ 20", 2, 1, 2);
  test("cord: 1 @ 20, cord: 2 @ 0", 2, 1, 2);
  // halves of the integrals over h = 2 of (1-z/h)^2: 7/12 and 1/12, of the
  // mixed product: 1/6 and 1/6
  test("cord: 1 @ 0, heavy: 1 @ 0",
       2 * 7. / 12 + 6 * 1. / 12,
       (2 + 6) / 6.,
       2 * 1. / 12 + 6 * 7. / 12);
}
