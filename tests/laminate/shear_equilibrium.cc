// SPDX-License-Identifier: LGPL-2.1-or-later

// The interlaminar shear stresses of any laminate vanish at both faces, are
// continuous between plies, and their integrals are the shear forces of the
// stiffness, for every law of transverse shear.

#include <deal.II/base/quadrature_lib.h>

#include "random_laminate.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  using Kind = TransverseShearLaw::Kind;
  using namespace Resultants;

  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random(-1, 1);
  const QGauss<1>                        quadrature(2);

  const std::vector<std::pair<std::string, TransverseShearLaw>> laws{
    {"constant strain", {Kind::constant_strain, 1}},
    {"factor", {Kind::factor, 0.7}},
    {"equilibrium", {Kind::equilibrium, 1}}};
  for (const auto &law : laws)
    {
      double at_faces = 0, jumps = 0, integrals = 0;
      for (unsigned int n = 0; n < 100; ++n)
        {
          const Laminate     laminate(random_plies(generator),
                                  ThicknessLaw::symmetric,
                                  random(generator),
                                  law.second);
          Resultants::Vector E;
          for (unsigned int i = 0; i < Resultants::n; ++i)
            E[i] = random(generator);
          const Resultants::Vector H = laminate.stiffness() * E;
          Tensor<1, 2>             Q;
          for (unsigned int a = 0; a < 2; ++a)
            for (unsigned int p = 0; p < 2; ++p)
              Q[a] += H[transverse(a, p)];

          Tensor<1, 2> below, integral;
          double       z = 0, maximum = 0, jump = 0;
          const auto   at = [&](const unsigned int ply, const double x) {
            const Tensor<1, 2> stress = laminate.interlaminar_stress(E, ply, x);
            maximum                   = std::max(maximum, stress.norm());
            return stress;
          };
          for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
            {
              const double t = laminate.get_plies()[p].thickness;
              // the first one is at the inner face
              jump  = std::max(jump, (at(p, z) - below).norm());
              below = at(p, z + t);
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                integral += t * quadrature.weight(q) *
                            at(p, z + t * quadrature.point(q)[0]);
              z += t;
            }
          jumps     = std::max(jumps, jump / maximum);
          at_faces  = std::max(at_faces, below.norm() / maximum);
          integrals = std::max(integrals, (integral - Q).norm() / Q.norm());
        }
      std::cout << law.first << std::endl;
      check_small("  at the inner face and between plies", jumps, 1e-12);
      check_small("  at the outer face", at_faces, 1e-11);
      check_small("  integrals", integrals, 1e-11);
    }
}
