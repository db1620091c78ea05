// SPDX-License-Identifier: LGPL-2.1-or-later

// The stresses within the plies, weighted with the shape functions of the two
// faces and integrated over the thickness, are the resultants of the stiffness,
// for every thickness law and every law of transverse shear, in a plate and in
// a shell.

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <random>

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  std::vector<Ply>
  stack()
  {
    const auto stiff =
      Material{500, 20, 7, 5, 4, 3, 0.4, 0.3, 0.2}.stiffness("ply");
    const auto soft = Material::isotropic(9, 0.45).stiffness("soft");
    return {{{stiff}, 1.2, 0.9, {}, 0},
            {{soft}, 0.4, 0, {}, 1},
            {{stiff}, 0.7, -0.3, {}, 2},
            {{stiff}, 2, 1.4, {}, 3}};
  }


  /** Call a function at points of each ply, with its number, the height and the
   * weight of the point in an integral over the thickness. */
  template <typename F>
  void
  at_points(const Laminate &laminate, const F &function)
  {
    const QGauss<1> quadrature(4);
    double          z = 0;
    for (unsigned int k = 0; k < laminate.get_plies().size(); ++k)
      {
        const double t = laminate.get_plies()[k].thickness;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          function(k, z + t * quadrature.point(q)[0], t * quadrature.weight(q));
        z += t;
      }
  }
} // namespace


int
main()
{
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random(-1, 1);

  const std::vector<std::pair<std::string, ThicknessLaw>> laws{
    {"symmetric", ThicknessLaw::symmetric},
    {"asymmetric", ThicknessLaw::asymmetric}};
  using Kind = TransverseShearLaw::Kind;
  const std::vector<TransverseShearLaw> shear_laws{
    {Kind::constant_strain, 1}, {Kind::factor, 0.6}, {Kind::equilibrium, 1}};
  const std::array<double, 2> plate{{0, 0}}, shell{{0.05, -0.03}};
  for (const auto &curvature : {plate, shell})
    for (const auto &law : laws)
      {
        double deviation = 0, thickness_strain = 0, constancy = 0, size = 0;
        for (unsigned int n = 0; n < 30; ++n)
          {
            const Laminate laminate(
              stack(), law.second, 1.1, shear_laws[n % 3], curvature);
            const double             h = laminate.thickness();
            const ThicknessFunctions w(h, 1.1, curvature);

            Resultants::Vector E;
            for (unsigned int i = 0; i < Resultants::n; ++i)
              E[i] = random(generator);

            using namespace Resultants;
            Resultants::Vector  H;
            double              mean_E_33 = 0;
            std::vector<double> S_33;
            at_points(
              laminate,
              [&](const unsigned int ply, const double z, const double weight) {
                const auto   s    = laminate.stress(E, ply, z);
                const auto   e    = laminate.strain(E, ply, z);
                const double N[2] = {1 - z / h, z / h};
                for (unsigned int p = 0; p < 2; ++p)
                  {
                    const double area = weight * w.area(z);
                    H[tangential(0, p)] += area * w.strain(0, p, z) * s[0][0];
                    H[tangential(1, p)] += area * w.strain(1, p, z) * s[1][1];
                    H[tangential(2, p)] += area * w.strain(2, p, z) * s[0][1];
                    H[transverse(0, p)] += weight * N[p] * s[0][2];
                    H[transverse(1, p)] += weight * N[p] * s[1][2];
                  }
                H[Resultants::thickness] += weight * w.area(z) * s[2][2];
                mean_E_33 += weight / h * e[2][2];
                S_33.push_back(s[2][2] * w.area(z));
              });
            const Resultants::Vector expected = laminate.stiffness() * E;
            size                              = std::max(size, expected.norm());
            deviation        = std::max(deviation, (H - expected).norm());
            thickness_strain = std::max(
              thickness_strain, std::abs(mean_E_33 - E[Resultants::thickness]));
            for (const double s : S_33)
              constancy = std::max(constancy, std::abs(s - S_33[0]));
          }

        std::cout << law.first << " law"
                  << (curvature == shell ? ", shell" : "") << std::endl;
        check_small("  resultants", deviation, 1e-13, size);
        check_small("  mean thickness strain", thickness_strain, 1e-13);
        if (law.second == ThicknessLaw::symmetric)
          check_small(
            "  the same thickness stress everywhere", constancy, 1e-13, size);
        else
          check_true("  a thickness stress that varies",
                     constancy > 1e-3 * size);
      }
}
