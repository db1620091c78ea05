// SPDX-License-Identifier: LGPL-2.1-or-later

// Transverse shear from equilibrium is finite and not negative for plies whose
// moduli differ by any number of orders of magnitude.

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  for (const double soft : {1e-5, 1e-12, 1e-20, 1e-100})
    for (const double stiff : {1e5, 1e20, 1e100})
      {
        const auto A      = Material::isotropic(soft, 0.3).stiffness("soft");
        const auto B      = Material::isotropic(stiff, 0.3).stiffness("stiff");
        bool       finite = true, positive = true;
        for (const std::vector<Ply> &plies :
             {std::vector<Ply>{{{A}, 1, 0.1, {}, 0}, {{B}, 1e-3, 0.2, {}, 1}},
              {{{B}, 1e-3, 0, {}, 0},
               {{A}, 1, 0, {}, 1},
               {{B}, 1e-3, 0, {}, 2}},
              {{{A}, 1, 0, {}, 0}, {{B}, 0.1, 0, {}, 1}, {{A}, 1, 0, {}, 2}}})
          {
            const Laminate     laminate(plies,
                                    ThicknessLaw::symmetric,
                                    0,
                                    {TransverseShearLaw::Kind::equilibrium, 1});
            Resultants::Vector E;
            for (unsigned int i = 6; i < 10; ++i)
              {
                E[i]     = 0.1;
                positive = positive && laminate.stiffness()[i][i] >= 0;
                for (unsigned int j = 6; j < 10; ++j)
                  finite = finite && std::isfinite(laminate.stiffness()[i][j]);
              }
            for (unsigned int p = 0; p < plies.size(); ++p)
              for (unsigned int a = 0; a < 2; ++a)
                finite =
                  finite &&
                  std::isfinite(laminate.interlaminar_stress(E, p, 0.5)[a]) &&
                  std::isfinite(laminate.stress(E, p, 0.5)[a][2]) &&
                  std::isfinite(laminate.strain(E, p, 0.5)[a][2]);
          }
        std::cout << "from " << soft << " to " << stiff << std::endl;
        check_true("  finite", finite);
        check_true("  positive", positive);
      }
}
