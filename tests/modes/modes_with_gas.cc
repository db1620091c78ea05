// SPDX-License-Identifier: LGPL-2.1-or-later

// A tube breathes with omega^2 = (E t (1 + g)^2/R + 2 n (p + p_a))/(rho t R)
// under the pressure p of a gas that is sealed in it, and without the second
// term if the gas can leave. Waves along the tube, which leave the volume
// unchanged, do not depend on the gas.

#include <algorithm>
#include <cmath>

#include <biface/solver/modal_analysis.h>

#include "../run_analysis.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double R = 100, t = 0.5, E = 2e3, rho = 1e-9, p = 0.05,
                   ambient = 0.1;

  std::vector<VibrationMode>
  modes(const std::string &gas)
  {
    return run_analysis(DATA_DIR "/gas_tube.prm",
                        {"Material wall/Density=1e-9",
                         "Stage 2/Gas=" + gas,
                         "Stage 2/Load factor=0",
                         "Stage 2/Steps=1",
                         "Stage 2/Modes=3"})
      .back()
      .modes->modes;
  }


  /** The one in which the whole wall moves. */
  const VibrationMode &
  breathing(const std::vector<VibrationMode> &modes)
  {
    return *std::max_element(
      modes.begin(), modes.end(), [](const auto &a, const auto &b) {
        return a.mass < b.mass;
      });
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // N = E t (g + g^2/2) = p R
  const double g             = std::sqrt(1 + 2 * p * R / (E * t)) - 1;
  const double wall          = E * t * (1 + g) * (1 + g) / R;
  const double gas           = 2 * (p + ambient);
  const auto   open          = modes("open");
  const auto   close         = modes("sealed");
  const double open_square   = breathing(open).square().real();
  const double sealed_square = breathing(close).square().real();
  check_small(
    "open", open_square - wall / (rho * t * R), 1e-3, wall / (rho * t * R));
  check_small(
    "sealed over open", sealed_square / open_square - (1 + gas / wall), 1e-5);
  check_small("a wave along the tube",
              close[2].frequency() - open[2].frequency(),
              1e-8,
              open[2].frequency());
}
