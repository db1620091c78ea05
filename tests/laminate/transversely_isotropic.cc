// SPDX-License-Identifier: LGPL-2.1-or-later

// The stiffness of a transversely isotropic material is the inverse of the
// compliance defined by its six constants.

#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  const double E_L = 510.45, E_T = 6.91, G_LT = 2.33, G_TT = 1.77, nu_LT = 0.46,
               nu_TT = 0.95;
  const SymmetricTensor<4, 3> stiffness =
    Material::transversely_isotropic(E_L, E_T, G_LT, G_TT, nu_LT, nu_TT)
      .stiffness("material");

  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      {
        // what a unit stress does to a bar or a block of the material
        SymmetricTensor<2, 3> stress, strain;
        stress[i][j] = 1;
        if (i != j)
          strain[i][j] = 1 / (2 * (i == 0 ? G_LT : G_TT));
        else if (i == 0)
          {
            strain[0][0] = 1 / E_L;
            strain[1][1] = strain[2][2] = -nu_LT / E_L;
          }
        else
          {
            strain[i][i]         = 1 / E_T;
            strain[3 - i][3 - i] = -nu_TT / E_T;
            strain[0][0]         = -nu_LT / E_L;
          }
        check_small("stress " + std::to_string(i + 1) + std::to_string(j + 1),
                    (stiffness * strain - stress).norm(),
                    1e-12);
      }
}
