// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/laminate/principal_axes.h>

namespace Biface
{
  using namespace dealii;

  std::array<PrincipalAxis, 3>
  principal_axes(const SymmetricTensor<2, 3> &tensor)
  {
    constexpr unsigned int max_sweeps = 30;

    // Jacobi's method: the axes remain orthogonal to round-off, also where
    // principal values coincide, as those of an undeformed shell do
    Tensor<2, 3> A(tensor), axes;
    for (unsigned int i = 0; i < 3; ++i)
      axes[i][i] = 1;
    const double small = std::numeric_limits<double>::epsilon() * A.norm();
    for (unsigned int sweep = 0; sweep < max_sweeps; ++sweep)
      {
        if (std::hypot(A[0][1], A[0][2], A[1][2]) <= 1e-3 * small)
          break;
        for (const auto &[p, q] : {std::array<unsigned int, 2>{{0, 1}},
                                   std::array<unsigned int, 2>{{0, 2}},
                                   std::array<unsigned int, 2>{{1, 2}}})
          {
            if (A[p][q] == 0)
              continue;
            const double half = (A[q][q] - A[p][p]) / (2 * A[p][q]);
            // of the two angles that make the entry zero the smaller one, with
            // which the sweeps converge
            const double t =
              (half < 0 ? -1 : 1) / (std::abs(half) + std::hypot(1., half));
            const double c = 1 / std::hypot(1., t), s = t * c;
            const auto   rotate = [c, s](double &x, double &y) {
              const double rotated = c * x - s * y;
              y                    = s * x + c * y;
              x                    = rotated;
            };
            for (unsigned int k = 0; k < 3; ++k)
              rotate(A[k][p], A[k][q]);
            for (unsigned int k = 0; k < 3; ++k)
              rotate(A[p][k], A[q][k]);
            for (unsigned int k = 0; k < 3; ++k)
              rotate(axes[k][p], axes[k][q]);
          }
      }
    std::array<PrincipalAxis, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      {
        result[i].value = A[i][i];
        for (unsigned int k = 0; k < 3; ++k)
          result[i].direction[k] = axes[k][i];
      }
    return result;
  }
} // namespace Biface
