// SPDX-License-Identifier: LGPL-2.1-or-later

// The stresses of each law are the derivatives of its energy by the strains,
// its moduli those of the stresses, and without strain there is no stress.

#include <biface/laminate/rubber.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  using Vector = PointStrains::Vector;
  using Matrix = PointStrains::Matrix;

  void
  test(const std::string &name, const MaterialLaw &law)
  {
    std::cout << name << std::endl;
    check_small(
      "  no stress without strain", law.stress(Vector()).norm(), 1e-13);
    double       worst_stress = 0, worst_modulus = 0, worst_thickness = 0;
    const double step = 1e-5;
    for (unsigned int i = 0; i < 20; ++i)
      {
        Vector strain;
        for (unsigned int k = 0; k < PointStrains::n; ++k)
          strain[k] = 0.15 * std::sin(1 + 7 * i + 3 * k);
        // stretches that coincide
        if (i == 0)
          strain = Vector({0.2, 0.2, 0, 0, 0, -0.1});
        if (i == 1)
          strain = Vector({0.2, 0.2 + 1e-7, 0, 0, 0, 0.2});
        Vector stress;
        Matrix moduli;
        law.evaluate(strain, stress, moduli);
        for (unsigned int k = 0; k < PointStrains::n; ++k)
          {
            Vector unit;
            unit[k] = step;
            const double by_energy =
              (law.energy(strain + unit) - law.energy(strain - unit)) /
              (2 * step);
            worst_stress = std::max(
              worst_stress, std::abs(by_energy - stress[k]) / stress.norm());
            const Vector by_stress =
              (law.stress(strain + unit) - law.stress(strain - unit)) /
              (2 * step);
            worst_modulus = std::max(
              worst_modulus, (by_stress - moduli[k]).norm() / moduli.norm());
          }
        const auto at = law.thickness_stress(strain);
        worst_thickness =
          std::max({worst_thickness,
                    std::abs(at.stress - stress[5]) / stress.norm(),
                    std::abs(at.modulus - moduli[5][5]) / moduli.norm()});
      }
    check_small("  stresses", worst_stress, 1e-7);
    check_small("  moduli", worst_modulus, 1e-7);
    check_small("  thickness stress", worst_thickness, 1e-12);

    Vector flat;
    flat[5] = -0.5;
    check_true("  no volume, no stress", !std::isfinite(law.stress(flat)[0]));
  }
} // namespace


int
main()
{
  test("neo-Hooke", NeoHooke(0.8, 30));
  test("Mooney-Rivlin", PolynomialRubber({{0.3, 0, 0}}, 0.1, 20));
  test("Yeoh", PolynomialRubber({{0.3, -0.02, 0.003}}, 0, 20));
  test("Ogden", OgdenRubber({{0.63, 1.3}, {0.0012, 5}, {-0.01, -2}}, 20));
}
