// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_random_laminate_h
#define biface_tests_random_laminate_h

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

/** One to six orthotropic plies, whose moduli differ by up to four orders of
 * magnitude, at any angle. */
inline std::vector<Biface::Ply>
random_plies(std::mt19937 &generator)
{
  std::uniform_real_distribution<double> exponent(0, 4), ratio(-0.4, 0.4),
    thickness(0.05, 1), angle(-dealii::numbers::PI, dealii::numbers::PI);
  std::uniform_int_distribution<unsigned int> number(1, 6);

  std::vector<Biface::Ply> plies(number(generator));
  for (unsigned int p = 0; p < plies.size(); ++p)
    {
      Biface::Material material;
      for (double *modulus : {&material.E_1,
                              &material.E_2,
                              &material.E_3,
                              &material.G_12,
                              &material.G_13,
                              &material.G_23})
        *modulus = std::pow(10, exponent(generator));
      // symmetric bounds on Poisson's ratios, so that the stiffness is
      // positive definite
      material.nu_12 =
        ratio(generator) * std::sqrt(material.E_1 / material.E_2);
      material.nu_13 =
        ratio(generator) * std::sqrt(material.E_1 / material.E_3);
      material.nu_23 =
        ratio(generator) * std::sqrt(material.E_2 / material.E_3);
      plies[p] = {{material.stiffness("random")},
                  thickness(generator),
                  angle(generator),
                  {},
                  p};
    }
  return plies;
}

#endif
