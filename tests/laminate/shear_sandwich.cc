// SPDX-License-Identifier: LGPL-2.1-or-later

// The transverse shear stiffness from equilibrium of a sandwich with thin stiff
// faces at a distance d and a soft core of thickness c is G d^2/c, however
// stiff the faces are in shear.

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  const double G[2] = {30, 12}, c = 2, t = 2e-4, d = c + t;
  const auto   face = Material::isotropic(1e9, 0.3).stiffness("face");
  const auto core = Material{1, 1, 1, 1, G[0], G[1], 0, 0, 0}.stiffness("core");
  const Laminate laminate(
    {{{face}, t, 0, {}, 0}, {{core}, c, 0, {}, 1}, {{face}, t, 0, {}, 2}},
    ThicknessLaw::symmetric,
    0,
    {TransverseShearLaw::Kind::equilibrium, 1});

  using namespace Resultants;
  for (unsigned int a = 0; a < 2; ++a)
    {
      double K = 0;
      for (unsigned int p = 0; p < 2; ++p)
        for (unsigned int q = 0; q < 2; ++q)
          K += laminate.stiffness()[transverse(a, p)][transverse(a, q)];
      const double exact = G[a] * d * d / c;
      check_small("direction " + std::to_string(a + 1), K - exact, 1e-6, exact);
    }
}
