// SPDX-License-Identifier: LGPL-2.1-or-later

// A stress along the cords of a ply causes the strains of the modulus E_L in
// tension and of E_L compression in compression, with the same Poisson's
// ratios, for every thickness law; initial stresses count.

#include <deal.II/base/numbers.h>

#include <biface/laminate/layup.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The strain along the cords under a stress along them, from the stress-free
   * state. */
  double
  cord_strain(const double stress, const double E_L, const double E_c)
  {
    return stress / (stress < 0 ? E_c : E_L);
  }


  /** The maximum deviation from the stress @p total along the cords, where it
   * was @p initial in the undeformed ply. */
  double
  deviation(const ThicknessLaw law, const double initial, const double total)
  {
    auto materials               = cord_ply();
    materials[0].E_L_compression = "E_L/50";
    const double E_L = materials[0].E_L, nu = materials[0].nu_LT;

    Layup::Parameters parameters;
    parameters.law   = law;
    parameters.plies = parse_plies("plies", "cord: 2 @ 35");
    parameters.initial_stresses =
      parse_ply_stresses("stresses", std::to_string(initial) + " 0 0");
    const Laminate laminate = Layup(parameters, materials).laminate(0);
    const Ply     &ply      = laminate.get_plies()[0];

    const double e =
      cord_strain(total, E_L, E_L / 50) - cord_strain(initial, E_L, E_L / 50);
    SymmetricTensor<2, 3> strain;
    strain[0][0] = e;
    strain[1][1] = strain[2][2] = -nu * e;
    strain                      = rotate_about_normal(strain, ply.angle);

    Resultants::Vector E;
    for (unsigned int face = 0; face < 2; ++face)
      for (unsigned int ab = 0; ab < 3; ++ab)
        E[Resultants::tangential(ab, face)] =
          (ab == 2 ? 2 : 1) * strain[Resultants::tangential_pairs[ab][0]]
                                    [Resultants::tangential_pairs[ab][1]];
    E[Resultants::thickness] = strain[2][2];

    SymmetricTensor<2, 3> expected;
    expected[0][0] = total;
    double largest = 0;
    for (const double z : {0.1, 1., 2.})
      {
        const auto stress =
          rotate_about_normal(laminate.stress(E, 0, z), -ply.angle) +
          ply.initial_stress;
        largest = std::max(largest, (stress - expected).norm());
        if (laminate.is_slack(E, 0, z) != (total < 0))
          largest = std::numeric_limits<double>::infinity();
      }
    return largest / std::max(std::abs(initial), std::abs(total));
  }
} // namespace


int
main()
{
  const std::pair<std::string, ThicknessLaw> laws[] = {
    {"symmetric", ThicknessLaw::symmetric},
    {"asymmetric", ThicknessLaw::asymmetric}};
  for (const auto &law : laws)
    {
      std::cout << law.first << " law" << std::endl;
      check_small("  tension", deviation(law.second, 0, 5), 1e-12);
      check_small("  compression", deviation(law.second, 0, -5), 1e-12);
      check_small("  tension lost", deviation(law.second, 5, -3), 1e-12);
      check_small("  more compression", deviation(law.second, -3, -5), 1e-12);
      check_small("  compression lost", deviation(law.second, -3, 5), 1e-12);
    }
}
