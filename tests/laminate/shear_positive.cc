// SPDX-License-Identifier: LGPL-2.1-or-later

// For any laminate, the transverse shear stiffness from equilibrium is
// symmetric and positive definite, and for equal strains of both faces never
// above that of constant strain.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include "random_laminate.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The ratio of the smallest to the largest eigenvalue. */
  double
  eigenvalue_ratio(const FullMatrix<double> &matrix)
  {
    LAPACKFullMatrix<double> lapack(matrix.m());
    lapack = matrix;
    FullMatrix<double> vectors;
    Vector<double>     values;
    lapack.compute_eigenvalues_symmetric(
      -1e100, 1e100, 1e-300, values, vectors);
    return values(0) / values(values.size() - 1);
  }


  FullMatrix<double>
  shear_stiffness(const Laminate &laminate)
  {
    FullMatrix<double> D(4);
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        D(i, j) = laminate.stiffness()[6 + i][6 + j];
    return D;
  }
} // namespace


int
main()
{
  std::mt19937 generator(1);
  double       asymmetry = 0, least = 1, excess = 0, gain = 0;
  for (unsigned int n = 0; n < 1000; ++n)
    {
      const std::vector<Ply> plies = random_plies(generator);
      const Laminate         constant_strain(plies, ThicknessLaw::symmetric, 0);
      const Laminate         equilibrium(plies,
                                 ThicknessLaw::symmetric,
                                 0,
                                 {TransverseShearLaw::Kind::equilibrium, 1});

      const FullMatrix<double> D = shear_stiffness(equilibrium);
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          asymmetry = std::max(asymmetry,
                               std::abs(D(i, j) - D(j, i)) /
                                 std::sqrt(D(i, i) * D(j, j)));
      least = std::min(least, eigenvalue_ratio(D));

      // the difference for equal strains of both faces, in the axes in which
      // the stiffness of constant strain is 1
      const FullMatrix<double> D_0 = shear_stiffness(constant_strain);
      SymmetricTensor<2, 2>    K, K_0;
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int c = a; c < 2; ++c)
          for (unsigned int p = 0; p < 2; ++p)
            for (unsigned int q = 0; q < 2; ++q)
              {
                K[a][c] += D(2 * a + p, 2 * c + q);
                K_0[a][c] += D_0(2 * a + p, 2 * c + q);
              }
      const auto   difference = eigenvalues(K_0 - K);
      const double size       = eigenvalues(K_0)[0];
      excess                  = std::max(excess, -difference[1] / size);
      gain                    = std::max(gain, difference[0] / size);
    }
  check_small("asymmetry", asymmetry, 1e-10);
  check_true("all eigenvalues are positive", least > 1e-8);
  check_small("not above constant strain", excess, 1e-10);
  check_true("far below it for some laminates", gain > 0.5);
}
