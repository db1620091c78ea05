// SPDX-License-Identifier: LGPL-2.1-or-later

// A gradient factor multiplies the stiffness G h/3 of a homogeneous wall
// against opposite shear strains of its faces; in any laminate, and with every
// law of transverse shear, it leaves the shear forces as they are, and the
// stresses in the plies have the resultants of the stiffness.

#include <deal.II/base/quadrature_lib.h>

#include "random_laminate.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;
using Kind = TransverseShearLaw::Kind;

namespace
{
  TransverseShear
  shear_of(const std::vector<Ply> &plies,
           TransverseShearLaw      law,
           const double            f)
  {
    law.gradient_factor = f;
    return Laminate(plies, ThicknessLaw::symmetric, 0, law)
      .get_transverse_shear();
  }
} // namespace


int
main()
{
  const double G = 3, h = 2, nu = 0.3;
  for (const auto kind : {Kind::constant_strain, Kind::equilibrium})
    {
      const TransverseShear shear =
        shear_of({{{Material::isotropic(2 * (1 + nu) * G, nu).stiffness("m")},
                   h,
                   0,
                   {}}},
                 {kind, 1},
                 8);
      // the strains of the faces are -1 and 1
      const double energy =
        (shear.stiffness(0, 0) - shear.stiffness(0, 1) - shear.stiffness(1, 0) +
         shear.stiffness(1, 1))[0][0];
      check_small("homogeneous wall", energy - 8 * G * h / 3, 1e-12, G * h);
    }

  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random(-1, 1);
  const QGauss<1>                        quadrature(3);
  for (const TransverseShearLaw law :
       {TransverseShearLaw{Kind::constant_strain, 1},
        {Kind::factor, 0.7},
        {Kind::equilibrium, 1}})
    {
      double change = 0, deviation = 0;
      for (unsigned int n = 0; n < 100; ++n)
        {
          const std::vector<Ply> plies  = random_plies(generator);
          const TransverseShear  before = shear_of(plies, law, 1),
                                shear   = shear_of(plies, law, 8);
          TransverseShear::FaceStrains strains;
          for (auto &strain : strains)
            for (unsigned int a = 0; a < 2; ++a)
              strain[a] = random(generator);
          const Tensor<1, 2> Q = before.shear_force(strains);
          change               = std::max(change,
                            (shear.shear_force(strains) - Q).norm() / Q.norm());

          std::array<Tensor<1, 2>, 2> H;
          double                      size = 0;
          for (unsigned int p = 0; p < 2; ++p)
            {
              for (unsigned int q = 0; q < 2; ++q)
                H[p] -= shear.stiffness(p, q) * strains[q];
              size = std::max(size, H[p].norm());
            }
          for (unsigned int k = 0; k < plies.size(); ++k)
            for (unsigned int i = 0; i < quadrature.size(); ++i)
              {
                const auto  &ply = shear.get_plies()[k];
                const double t   = ply.end - ply.begin;
                const double z   = ply.begin + t * quadrature.point(i)[0];
                const double s   = 2 * z / shear.get_thickness() - 1;
                for (unsigned int p = 0; p < 2; ++p)
                  H[p] += t * quadrature.weight(i) * (p == 0 ? 1 - s : 1 + s) /
                          2 * shear.stress(strains, k, z);
              }
          for (const auto &difference : H)
            deviation = std::max(deviation, difference.norm() / size);
        }
      check_small("shear forces", change, 1e-10);
      check_small("resultants of the stresses", deviation, 1e-10);
    }
}
