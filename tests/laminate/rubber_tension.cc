// SPDX-License-Identifier: LGPL-2.1-or-later

// In uniaxial, equibiaxial and planar tension the laws of rubber have the
// nominal stresses of the closed forms, without a change of volume: to 1e-6 by
// extrapolation to an infinite bulk modulus.

#include <functional>

#include <biface/laminate/material_parameters.h>
#include <biface/laminate/ply_points.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  enum class Tension
  {
    uniaxial,
    equibiaxial,
    planar
  };


  /** The nominal stress along the first axis, without a stress across. */
  double
  nominal_stress(const MaterialLaw &law,
                 const Tension      tension,
                 const double       stretch)
  {
    PointStrains::Vector strain;
    strain[0]         = (stretch * stretch - 1) / 2;
    const auto stress = [&](const double e_22) {
      strain[1]                       = e_22;
      strain[PointStrains::thickness] = thickness_strain(law, {}, strain, 0);
      return law.stress(strain);
    };
    if (tension == Tension::equibiaxial)
      return stretch * stress(strain[0])[0];
    if (tension == Tension::planar)
      return stretch * stress(0)[0];

    // the second principal stress vanishes, too
    const double guess = 1 / stretch;
    double       low = (0.9 * guess - 1) / 2, high = (1.1 * guess - 1) / 2;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double middle                  = (low + high) / 2;
        (stress(middle)[1] > 0 ? high : low) = middle;
      }
    return stretch * stress(low)[0];
  }


  /** The one of an incompressible rubber, by the derivatives of the energy by
   * the principal stretches: along the axis less across. */
  double
  exact(const Tension                                      tension,
        const double                                       stretch,
        const std::function<double(const double, double)> &w)
  {
    // the last stretch, and how its change follows that of the first: the
    // pressure makes its stress vanish
    const double across = tension == Tension::uniaxial ? 1 / std::sqrt(stretch)
                          : tension == Tension::planar
                            ? 1 / stretch
                            : 1 / (stretch * stretch);
    const double second = tension == Tension::uniaxial ? across
                          : tension == Tension::planar ? 1
                                                       : stretch;
    const double I_1    = stretch * stretch + second * second + across * across;
    return w(stretch, I_1) - across / stretch * w(across, I_1);
  }


  void
  test(const std::string                                 &name,
       const MaterialParameters                          &parameters,
       const std::function<double(const double, double)> &w)
  {
    std::cout << name << std::endl;
    for (const auto &[text, tension] :
         {std::make_pair("uniaxial", Tension::uniaxial),
          std::make_pair("equibiaxial", Tension::equibiaxial),
          std::make_pair("planar", Tension::planar)})
      {
        double largest = 0;
        for (const double stretch : {0.7, 1.001, 1.2, 2., 3.})
          {
            std::array<double, 2> of_bulk_modulus;
            for (unsigned int i = 0; i < 2; ++i)
              {
                MaterialParameters material = parameters;
                material.K                  = i == 0 ? 2e5 : 4e5;
                of_bulk_modulus[i] =
                  nominal_stress(*material.laws().rubber, tension, stretch);
              }
            const double limit    = 2 * of_bulk_modulus[1] - of_bulk_modulus[0];
            const double expected = exact(tension, stretch, w);
            largest               = std::max(largest,
                               std::abs(limit - expected) / std::abs(expected));
          }
        check_small(std::string("  ") + text, largest, 1e-6);
      }
  }
} // namespace


int
main()
{
  using Type = MaterialParameters::Type;
  MaterialParameters material;
  material.name = "rubber";

  // w: the derivative of the energy by a principal stretch l; that of I_2 by
  // the identity I_2 = (I_1^2 - l_1^4 - l_2^4 - l_3^4)/2
  material.type = Type::neo_Hooke;
  material.mu   = 0.8;
  test("neo-Hooke", material, [](const double l, double) { return 0.8 * l; });

  material      = MaterialParameters();
  material.name = "rubber";
  material.type = Type::Mooney_Rivlin;
  material.c10  = 0.3;
  material.c01  = 0.1;
  test("Mooney-Rivlin", material, [](const double l, double I_1) {
    return 2 * 0.3 * l + 2 * 0.1 * (I_1 * l - l * l * l);
  });

  material.type = Type::Yeoh;
  material.c01  = 0;
  material.c20  = -0.02;
  material.c30  = 0.003;
  test("Yeoh", material, [](const double l, double I_1) {
    const double x = I_1 - 3;
    return 2 * l * (0.3 - 2 * 0.02 * x + 3 * 0.003 * x * x);
  });

  // the three terms of Ogden (1972) for Treloar's rubber
  material         = MaterialParameters();
  material.name    = "rubber";
  material.type    = Type::Ogden;
  material.mu_i    = {0.63, 0.0012, -0.01};
  material.alpha_i = {1.3, 5, -2};
  test("Ogden", material, [](const double l, double) {
    return 0.63 * std::pow(l, 0.3) + 0.0012 * std::pow(l, 4) -
           0.01 * std::pow(l, -3);
  });
}
