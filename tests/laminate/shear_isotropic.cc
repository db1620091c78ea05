// SPDX-License-Identifier: LGPL-2.1-or-later

// The transverse shear stiffness from equilibrium of an isotropic shell is 5/6
// of that of constant strain, and its stresses are a parabola, also if the
// shell is divided into plies of the same material.

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  const double E = 1000, nu = 0.3, h = 2, G = E / (2 * (1 + nu));

  for (const auto &thicknesses :
       {std::vector<double>{h}, {h / 2, h / 2}, {0.3, 0.5, h - 0.8}})
    {
      std::cout << "plies: " << thicknesses.size() << std::endl;
      std::vector<Ply> plies;
      double           angle = 0;
      for (const double t : thicknesses)
        plies.push_back({{Material::isotropic(E, nu).stiffness("material")},
                         t,
                         angle += 0.3,
                         {}});
      const Laminate laminate(plies,
                              ThicknessLaw::symmetric,
                              0.7,
                              {TransverseShearLaw::Kind::equilibrium, 1});
      const Laminate given(plies,
                           ThicknessLaw::symmetric,
                           0.7,
                           {TransverseShearLaw::Kind::factor, 5. / 6});

      using namespace Resultants;
      Tensor<2, 2> stiffness, by_factor, exact, coupling;
      for (unsigned int a = 0; a < 2; ++a)
        {
          exact[a][a] = 5. / 6 * G * h;
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int p = 0; p < 2; ++p)
              for (unsigned int q = 0; q < 2; ++q)
                {
                  const unsigned int i = transverse(a, p), j = transverse(c, q);
                  stiffness[a][c] += laminate.stiffness()[i][j];
                  by_factor[a][c] += given.stiffness()[i][j];
                  coupling[a][c] +=
                    (p == outer ? 1 : -1) * laminate.stiffness()[i][j];
                }
        }
      check_small("  stiffness", (stiffness - exact).norm(), 1e-14, G * h);
      check_small("  given factor", (by_factor - exact).norm(), 1e-14, G * h);
      check_small("  no coupling with the difference of the faces",
                  coupling.norm(),
                  1e-14,
                  G * h);

      Resultants::Vector strains;
      for (unsigned int face = 0; face < 2; ++face)
        {
          strains[transverse(0, face)] = 0.1;
          strains[transverse(1, face)] = -0.2;
        }
      Tensor<1, 2> Q;
      Q[0]             = 0.1 * exact[0][0];
      Q[1]             = -0.2 * exact[1][1];
      double deviation = 0, interlaminar = 0, z = 0;
      for (unsigned int p = 0; p < thicknesses.size(); ++p)
        {
          for (const double fraction : {0., 0.4, 1.})
            {
              const double       x        = z + fraction * thicknesses[p];
              const Tensor<1, 2> parabola = 6 * x * (h - x) / (h * h * h) * Q;
              const SymmetricTensor<2, 3> stress =
                laminate.stress(strains, p, x);
              for (unsigned int a = 0; a < 2; ++a)
                deviation =
                  std::max(deviation, std::abs(stress[a][2] - parabola[a]));
              interlaminar = std::max(
                interlaminar,
                (laminate.interlaminar_stress(strains, p, x) - parabola)
                  .norm());
            }
          z += thicknesses[p];
        }
      check_small("  stresses", deviation, 1e-14, G);
      check_small("  interlaminar stresses", interlaminar, 1e-14, G);
    }
}
