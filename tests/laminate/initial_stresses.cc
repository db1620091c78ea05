// SPDX-License-Identifier: LGPL-2.1-or-later

// Initial ply stresses give resultants that are their integrals with the shape
// functions of the faces, in the frame of the shell.

#include <biface/laminate/layup.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string         &what,
       const std::string         &plies,
       const std::string         &stresses,
       const std::vector<double> &tangential)
  {
    Layup::Parameters parameters;
    parameters.plies            = parse_plies("plies", plies);
    parameters.initial_stresses = parse_ply_stresses("stresses", stresses);
    Resultants::Vector expected;
    for (unsigned int i = 0; i < tangential.size(); ++i)
      expected[i] = tangential[i];
    check_small(
      what,
      (Layup(parameters, cord_ply()).laminate(0).initial_resultants() -
       expected)
        .norm(),
      1e-13);
  }
} // namespace


int
main()
{
  test("none", "cord: 1 @ 20, cord: 1 @ 0", "", {});

  // h/2 to each face; the order is 11-, 11+, 22-, 22+, 12-, 12+
  test("uniform", "cord: 2 @ 0", "3 5 7", {3, 3, 5, 5, 7, 7});

  // the inner half of h = 2: 3/4 to the inner face, 1/4 to the outer one
  test("inner ply",
       "cord: 1 @ 0, cord: 1 @ 0",
       "4 8 12, 0 0 0",
       {3, 1, 6, 2, 9, 3});
  test("bending", "cord: 1 @ 0, cord: 1 @ 0", "-4 0 0, 4 0 0", {-2, 2});

  // at 30 degrees: cos^2 = 3/4, sin^2 = 1/4, cos sin = sqrt(3)/4
  const double s = std::sqrt(3.);
  test(
    "along cords at 30 degrees", "cord: 2 @ 30", "4 0 0", {3, 3, 1, 1, s, s});
  test("along cords at -30 degrees",
       "cord: 2 @ -30",
       "4 0 0",
       {3, 3, 1, 1, -s, -s});
  test("across cords at 90 degrees", "cord: 2 @ 90", "0 4 0", {4, 4});
  test("shear at 45 degrees", "cord: 2 @ 45", "0 0 4", {-4, -4, 4, 4});

  // stresses across the thickness, which only a program can give
  Ply ply{{}, 2, 0, {}};
  ply.laws.stiffness       = Material::isotropic(1, 0.2).stiffness("ply");
  ply.initial_stress[0][2] = 3;
  ply.initial_stress[1][2] = 5;
  ply.initial_stress[2][2] = 7;
  const auto H =
    Laminate({ply}, ThicknessLaw::symmetric, 1).initial_resultants();
  Resultants::Vector expected;
  expected[6] = expected[7] = 3;
  expected[8] = expected[9] = 5;
  expected[10]              = 14;
  check_small("transverse", (H - expected).norm(), 1e-13);
}
