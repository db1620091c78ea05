// SPDX-License-Identifier: LGPL-2.1-or-later

// A gas sealed behind the wall of a tube stiffens shapes that change its
// volume, also by the pressure that changes with the loads. Compressed along
// its axis, the panel buckles under 1/c + sum_k F_k^2/(L/2 b_k^2 (P_k - P)) = 0
// with odd k, F_k = 2/b_k, b_k = k pi/L, P_k = D b_k^2 + E h/(R^2 b_k^2) and c
// = p_a b/V, or under P_2 in two half waves, with and without the gas. A tube
// from which the gas is drawn by its moving end breathes without stiffness at
// p + p_a = -E t (1 + g)^2/(2 n R).

#include <array>
#include <cmath>
#include <string>

#include <biface/stepping/buckling.h>
#include <biface/stepping/sensitivity_table.h>

#include "../run_analysis.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double E = 1e5, h = 0.5, R = 1000, L = 40, b = 10, V = 1e6;

  /** P_k */
  double
  without_gas(const unsigned int k)
  {
    const double square = std::pow(k * numbers::PI / L, 2);
    return E * h * h * h / 12 * square + E * h / (R * R * square);
  }


  /** The solution between P_1 and P_3. */
  double
  with_gas(const double ambient)
  {
    double low = without_gas(1), high = without_gas(3);
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double P   = (low + high) / 2;
        double       sum = V / (ambient * b);
        for (unsigned int k = 1; k < 100; k += 2)
          sum +=
            8 / (L * std::pow(k * numbers::PI / L, 4) * (without_gas(k) - P));
        (sum > 0 ? high : low) = P;
      }
    return low;
  }


  /** The two lowest critical loads. */
  std::array<double, 2>
  critical(const std::string &gas, const double ambient)
  {
    const auto loads =
      run_analysis(DATA_DIR "/compressed_tube.prm",
                   {"Gas/Ambient pressure=" + std::to_string(ambient),
                    "Stage 1/Gas=" + gas})
        .back()
        .buckling->loads;
    return {{loads.at(0).level.factors[0], loads.at(1).level.factors[0]}};
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  constexpr double exact = 3e-3;
  const auto       open  = critical("open", 100);
  check_small("one half wave, open", open[0] / without_gas(1) - 1, exact);
  check_small("two half waves, open", open[1] / without_gas(2) - 1, exact);
  const auto soft = critical("sealed", 100);
  check_small("one half wave", soft[0] / with_gas(100) - 1, exact);
  check_small("two half waves", soft[1] / open[1] - 1, 1e-7);
  const auto derivatives =
    run_analysis(DATA_DIR "/compressed_tube.prm",
                 {"Gas/Ambient pressure=100",
                  "Stage 1/Gas=sealed",
                  "Sensitivities/Entries=Gas/Ambient pressure",
                  "Sensitivities/Outputs=buckling factor 1"})
      .back()
      .sensitivities;
  check_small("its derivative by the gas",
              derivatives->logarithmic(0, 0) -
                std::log(with_gas(100.1) / with_gas(99.9)) /
                  std::log(100.1 / 99.9),
              exact);
  const auto stiff = critical("sealed", 500);
  check_small("two half waves first", stiff[0] / open[1] - 1, 1e-7);
  check_small("then one", stiff[1] / with_gas(500) - 1, exact);

  // many shapes would buckle before this one with a softer gas
  constexpr double p = 0.05, surrounding = 0.1, n = 50, wall = 2e3 * 0.5 / 100;
  const auto       tube = run_analysis(DATA_DIR "/gas_tube.prm",
                                 {"Gas/Polytropic exponent=50",
                                        "Mesh/Intervals alpha_2=0:0.1:1",
                                        "Supports/alpha_1 max=v_1 both=5",
                                        "Stage 2/Load factor=0.001",
                                        "Stage 2/Steps=1",
                                        "Stage 2/Buckling=1"})
                      .back()
                      .buckling->loads.at(0);
  // (1 + g)^2 = 1 + 2 p/wall
  const double breathing = (wall + 2 * p) / (2 * n);
  check_small(
    "breathing", (tube.level.pressure + surrounding) / breathing + 1, 1e-3);
  check_small("of the given loads",
              tube.factor * 0.001 / tube.level.factors[0] - 1,
              1e-8);
}
