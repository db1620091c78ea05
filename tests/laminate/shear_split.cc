// SPDX-License-Identifier: LGPL-2.1-or-later

// Plies that are split in two have the same transverse shear stiffness from
// equilibrium and the same interlaminar stresses as before.

#include "random_laminate.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  const TransverseShearLaw equilibrium{TransverseShearLaw::Kind::equilibrium,
                                       1};
  std::mt19937             generator(1);
  std::uniform_real_distribution<double> random(0.1, 0.9);
  double                                 stiffness = 0, stress = 0;
  for (unsigned int n = 0; n < 50; ++n)
    {
      const std::vector<Ply> plies = random_plies(generator);
      std::vector<Ply>       halves;
      for (const Ply &ply : plies)
        {
          const double fraction = random(generator);
          for (const double part : {fraction, 1 - fraction})
            {
              halves.push_back(ply);
              halves.back().thickness *= part;
            }
        }
      const Laminate whole(plies, ThicknessLaw::symmetric, 0, equilibrium);
      const Laminate split(halves, ThicknessLaw::symmetric, 0, equilibrium);

      double largest = 0, deviation = 0;
      for (unsigned int i = 6; i < 10; ++i)
        for (unsigned int j = 6; j < 10; ++j)
          {
            const double value = whole.stiffness()[i][j];
            largest            = std::max(largest, std::abs(value));
            deviation =
              std::max(deviation, std::abs(split.stiffness()[i][j] - value));
          }
      stiffness = std::max(stiffness, deviation / largest);

      Resultants::Vector E;
      for (unsigned int i = 6; i < 10; ++i)
        E[i] = random(generator);
      const unsigned int last = plies.size() - 1;
      const double       z = whole.thickness() - 0.05 * plies[last].thickness;
      const Tensor<1, 2> expected = whole.interlaminar_stress(E, last, z);
      stress                      = std::max(
        stress,
        (split.interlaminar_stress(E, 2 * last + 1, z) - expected).norm() /
          expected.norm());
    }
  check_small("stiffness", stiffness, 1e-11);
  check_small("stresses", stress, 1e-9);
}
