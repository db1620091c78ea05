// SPDX-License-Identifier: LGPL-2.1-or-later

// Both failure indices are 1 at each strength alone and proportional to the
// stress. Maximum stress ignores interaction; Tsai-Wu does not, and has the
// value computed by hand for a combined stress.

#include <functional>

#include <biface/laminate/failure_criteria.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  SymmetricTensor<2, 3>
  stress(const double s_L, const double s_T, const double t_LT)
  {
    SymmetricTensor<2, 3> s;
    s[0][0] = s_L;
    s[1][1] = s_T;
    s[0][1] = t_LT;
    return s;
  }
} // namespace


int
main()
{
  const Strengths s{1500, 900, 40, 246, 68};

  const std::vector<
    std::pair<std::string,
              std::function<double(const SymmetricTensor<2, 3> &)>>>
    criteria{{"maximum stress",
              [&](const auto &t) { return maximum_stress_index(t, s); }},
             {"Tsai-Wu", [&](const auto &t) { return tsai_wu_index(t, s); }}};
  for (const auto &criterion : criteria)
    {
      std::cout << criterion.first << std::endl;
      const auto &index = criterion.second;
      check_small("  X_t", index(stress(s.X_t, 0, 0)) - 1, 1e-14);
      check_small("  X_c", index(stress(-s.X_c, 0, 0)) - 1, 1e-14);
      check_small("  Y_t", index(stress(0, s.Y_t, 0)) - 1, 1e-14);
      check_small("  Y_c", index(stress(0, -s.Y_c, 0)) - 1, 1e-14);
      check_small("  S", index(stress(0, 0, s.S)) - 1, 1e-14);
      check_small(
        "  S of the other sign", index(stress(0, 0, -s.S)) - 1, 1e-14);
      check_small("  no stress", index(stress(0, 0, 0)), 0);

      // 3 and -1 times a stress: the latter is another index, not negative
      const auto t = stress(300, -50, 20);
      check_small("  in proportion", index(3 * t) / index(t) - 3, 1e-14);
      check_true("  reversed, not negative", index(-t) > 0);

      // what the plane of the ply does not see
      auto across  = t;
      across[2][2] = 1e3;
      across[0][2] = 1e3;
      across[1][2] = 1e3;
      check_small("  of the plane alone", index(across) - index(t), 0);
    }

  check_small("maximum stress of half of two strengths",
              maximum_stress_index(stress(s.X_t / 2, s.Y_t / 2, 0), s) - 0.5,
              1e-14);

  // equal strengths 1 in tension and compression: the quadratic form is
  // 0.64 + 0.36 + 0.25 - 0.8*0.6 = 0.77, and the index its root
  const Strengths unit{1, 1, 1, 1, 1};
  check_small("Tsai-Wu of equal strengths",
              tsai_wu_index(stress(0.8, 0.6, 0.5), unit) - std::sqrt(0.77),
              1e-14);
  check_small("and with the signs opposed",
              tsai_wu_index(stress(0.8, -0.6, 0.5), unit) - std::sqrt(1.73),
              1e-14);

  // X_t = 2, X_c = 1, Y_t = 1, Y_c = 4, S = 1 at (1, 1, 1): the linear part is
  // -1/2 + 3/4 = 1/4, the quadratic one 1/2 + 1/4 + 1 - sqrt(1/8); the stresses
  // fail where they are multiplied by the root R of q R^2 + R/4 = 1
  const double q = 1.75 - std::sqrt(0.125);
  const double R = (-0.25 + std::sqrt(0.0625 + 4 * q)) / (2 * q);
  check_small("Tsai-Wu of unequal strengths",
              tsai_wu_index(stress(1, 1, 1), {2, 1, 1, 4, 1}) - 1 / R,
              1e-14);
}
