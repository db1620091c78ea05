// SPDX-License-Identifier: LGPL-2.1-or-later

// A gas sealed in a tube whose end moves inward has the pressure p at which (p
// + p_a) V^n is constant, while the hoop tension p r of the wall, of modulus E
// and thickness t, stretches it: V/V_0 = (1 + u/R)^2 (1 + e), u/R = p R (1 +
// e)/(E t).

#include <cmath>

#include <biface/model/state/loads.h>

#include "../run_analysis.h"
#include <tests.h>

using namespace dealii;

namespace
{
  constexpr double R = 100, t = 0.5, E = 2e3, ambient = 0.1, before = 0.05,
                   length = 50;

  /** The volume per undeformed volume. */
  double
  stretch(const double p, const double e)
  {
    return std::pow(1 + p * R * (1 + e) / (E * t), 2) * (1 + e);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string n : {"1", "1.4"})
    {
      const auto reports = run_analysis(DATA_DIR "/gas_tube.prm",
                                        {"Gas/Polytropic exponent=" + n});
      for (unsigned int i = 1; i < reports.size(); ++i)
        {
          const double e = -5 * reports[i].loads->factors[0] / length;
          double       p = before;
          for (unsigned int k = 0; k < 50; ++k)
            p = (before + ambient) *
                  std::pow(stretch(before, 0) / stretch(p, e), std::stod(n)) -
                ambient;
          check_small("n = " + n + ", end moved by " + std::to_string(i) +
                        "/2: pressure",
                      reports[i].loads->pressure - p,
                      2e-3,
                      p);
          check_true("  no more than 5 iterations", reports[i].iterations <= 5);
        }
    }
}
