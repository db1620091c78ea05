// SPDX-License-Identifier: LGPL-2.1-or-later

// If all plies are turned by 90 degrees, the two directions of transverse shear
// from equilibrium change places.

#include "random_laminate.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  using namespace Resultants;

  const TransverseShearLaw equilibrium{TransverseShearLaw::Kind::equilibrium,
                                       1};
  std::mt19937             generator(1);
  double                   stiffness = 0, stress = 0;
  for (unsigned int n = 0; n < 20; ++n)
    {
      std::vector<Ply> plies = random_plies(generator);
      const Laminate   laminate(plies, ThicknessLaw::symmetric, 0, equilibrium);
      for (Ply &ply : plies)
        ply.angle += numbers::PI / 2;
      const Laminate turned(plies, ThicknessLaw::symmetric, 0, equilibrium);

      // e_1 becomes e_2, e_2 becomes -e_1
      double largest = 0, deviation = 0;
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int c = 0; c < 2; ++c)
          for (unsigned int p = 0; p < 2; ++p)
            for (unsigned int q = 0; q < 2; ++q)
              {
                const double before =
                  laminate.stiffness()[transverse(a, p)][transverse(c, q)];
                const double after =
                  turned
                    .stiffness()[transverse(1 - a, p)][transverse(1 - c, q)];
                largest   = std::max(largest, std::abs(before));
                deviation = std::max(
                  deviation, std::abs(before - (a == c ? 1 : -1) * after));
              }
      stiffness = std::max(stiffness, deviation / largest);

      Resultants::Vector E, E_turned;
      for (unsigned int p = 0; p < 2; ++p)
        {
          E[transverse(0, p)] = E_turned[transverse(1, p)] = 0.3;
          E[transverse(1, p)]                              = 0.2;
          E_turned[transverse(0, p)]                       = -0.2;
        }
      const double       z      = 0.7 * laminate.get_plies()[0].thickness;
      const Tensor<1, 2> before = laminate.interlaminar_stress(E, 0, z);
      const Tensor<1, 2> after  = turned.interlaminar_stress(E_turned, 0, z);
      stress                    = std::max(
        stress,
        (std::abs(before[0] - after[1]) + std::abs(before[1] + after[0])) /
          before.norm());
    }
  check_small("stiffness", stiffness, 1e-11);
  check_small("stresses", stress, 1e-11);
}
