// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/laminate/failure_criteria.h>

namespace Biface
{
  using namespace dealii;

  double
  maximum_stress_index(const SymmetricTensor<2, 3> &stress, const Strengths &s)
  {
    const double s_L = stress[0][0], s_T = stress[1][1], t_LT = stress[0][1];
    // strengths in compression are positive numbers; below zero a ratio is no
    // failure, and that of the other sign counts
    return std::max({s_L / s.X_t,
                     -s_L / s.X_c,
                     s_T / s.Y_t,
                     -s_T / s.Y_c,
                     std::abs(t_LT) / s.S});
  }


  double
  tsai_wu_index(const SymmetricTensor<2, 3> &stress, const Strengths &s)
  {
    const double s_L = stress[0][0], s_T = stress[1][1], t_LT = stress[0][1];

    const double F_11 = 1 / (s.X_t * s.X_c), F_22 = 1 / (s.Y_t * s.Y_c);
    // Tsai and Wu: F_i sigma_i + F_ij sigma_i sigma_j = 1 with F_12 =
    // -sqrt(F_11 F_22)/2, section 4 of doc/theory.md
    const double linear =
      (1 / s.X_t - 1 / s.X_c) * s_L + (1 / s.Y_t - 1 / s.Y_c) * s_T;
    const double quadratic = F_11 * s_L * s_L + F_22 * s_T * s_T +
                             t_LT * t_LT / (s.S * s.S) -
                             std::sqrt(F_11 * F_22) * s_L * s_T;
    // stresses times R cause failure if quadratic R^2 + linear R = 1
    return (linear + std::sqrt(linear * linear + 4 * quadratic)) / 2;
  }
} // namespace Biface
