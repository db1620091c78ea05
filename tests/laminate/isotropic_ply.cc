// SPDX-License-Identifier: LGPL-2.1-or-later

// An isotropic laminate has the membrane and bending stiffness of plane stress
// once the thickness strain is eliminated.

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const double E = 1000, nu = 0.3, h = 2;

  /** The stiffness of a stack whose thickness strain is free. */
  struct Stiffness
  {
    /** The components are in the order 11, 22, 12. */
    Tensor<2, 3> membrane, coupling, bending;
    Tensor<2, 2> shear;

    explicit Stiffness(Resultants::Matrix D)
    {
      using namespace Resultants;

      for (unsigned int i = 0; i < thickness; ++i)
        for (unsigned int j = 0; j < thickness; ++j)
          D[i][j] -=
            D[i][thickness] * D[thickness][j] / D[thickness][thickness];

      for (unsigned int p = 0; p < 2; ++p)
        for (unsigned int q = 0; q < 2; ++q)
          {
            // faces at the distances z from the middle
            const double z_p = (p == outer ? h / 2 : -h / 2);
            const double z_q = (q == outer ? h / 2 : -h / 2);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                {
                  const double d = D[tangential(i, p)][tangential(j, q)];
                  membrane[i][j] += d;
                  coupling[i][j] += d * z_q;
                  bending[i][j] += d * z_p * z_q;
                }
            for (unsigned int i = 0; i < 2; ++i)
              for (unsigned int j = 0; j < 2; ++j)
                shear[i][j] += D[transverse(i, p)][transverse(j, q)];
          }
    }
  };


  Stiffness
  stack(const std::vector<double> &thicknesses)
  {
    std::vector<Ply> plies;
    double           angle = 0;
    for (const double t : thicknesses)
      plies.push_back({{Material::isotropic(E, nu).stiffness("material")},
                       t,
                       angle += 0.3,
                       {}});
    return Stiffness(Laminate(plies, ThicknessLaw::symmetric, 0).stiffness());
  }
} // namespace


int
main()
{
  Tensor<2, 3> plane_stress;
  plane_stress[0][0] = plane_stress[1][1] = E / (1 - nu * nu);
  plane_stress[0][1] = plane_stress[1][0] = nu * E / (1 - nu * nu);
  const double G = plane_stress[2][2] = E / (2 * (1 + nu));

  Tensor<2, 2> shear;
  shear[0][0] = shear[1][1] = G * h;

  const double I = h * h * h / 12;
  for (const auto &plies : {std::vector<double>{h}, {0.3, 0.5, h - 0.8}})
    {
      std::cout << plies.size() << " plies" << std::endl;
      const Stiffness D = stack(plies);
      check_small("  membrane", (D.membrane - h * plane_stress).norm(), 1e-9);
      check_small("  coupling", D.coupling.norm(), 1e-9);
      check_small("  bending", (D.bending - I * plane_stress).norm(), 1e-9);
      check_small("  transverse shear", (D.shear - shear).norm(), 1e-9);
    }
}
