// SPDX-License-Identifier: LGPL-2.1-or-later

// Waves of the air in a rigid torus have the frequencies
// n c/(2 pi) sqrt(int dA/r/int r dA), on N pieces times sin(n pi/N)/(n pi/N).
// Air in which sound is very fast is a gas that is sealed in
// adiabatically.

#include <cmath>

#include <biface/solver/modal_analysis.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  std::vector<VibrationMode>
  modes(const std::vector<Override> &changes)
  {
    std::vector<Override> overrides{"Material cord/Density=1.2e-9",
                                    "Mesh/Intervals alpha_1=-120:120:16",
                                    "Mesh/Intervals alpha_2=-180:180:20",
                                    "Gas/Ambient pressure=0.1",
                                    "Loads/Pressure type=follower",
                                    "Number of stages=2",
                                    "Stage 2/Contact=false",
                                    "Stage 2/Travel=unchanged",
                                    "Stage 2/Steps=1"};
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    return run_analysis(PRM_DIR "/bias_tire.prm", overrides)
      .back()
      .modes->modes;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // a wall as stiff as steel, and weightless: nothing but the air moves
  constexpr double   c = 343000, N = 20, R = 200, a = 50;
  constexpr double   end        = 2 * numbers::PI / 3;
  const double       rim        = R + a * std::cos(end);
  double             of_inverse = 0, of_radius = 0;
  const unsigned int n_parts = 10000;
  for (unsigned int k = 0; k < n_parts; ++k)
    {
      const double psi = end * (2 * (k + 0.5) / n_parts - 1),
                   r   = R + a * std::cos(psi);
      const double dz  = a * std::cos(psi) * 2 * end / n_parts;
      of_inverse += std::log(r / rim) * dz;
      of_radius += (r * r - rim * rim) / 2 * dz;
    }
  const auto waves = modes({"Material cord/E_L=1e8",
                            "Material cord/E_T=1e7",
                            "Material cord/G_LT=5e6",
                            "Material cord/G_TT=3e6",
                            "Material cord/Density=1e-12",
                            "Gas/Sound speed=" + std::to_string(c),
                            "Stage 2/Modes=4"});
  for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int n  = 1 + i / 2;
      const double expected = N / numbers::PI * std::sin(n * numbers::PI / N) *
                              c / (2 * numbers::PI) *
                              std::sqrt(of_inverse / of_radius);
      check_small(
        "wave " + std::to_string(n), waves[i].frequency() / expected - 1, 2e-3);
      check_small("its energy in the wall", 1 - waves[i].part_of_air, 1e-3);
    }

  const auto fast   = modes({"Gas/Sound speed=3.43e7", "Stage 2/Modes=6"}),
             sealed = modes({"Gas/Polytropic exponent=1.4",
                             "Stage 2/Pressure=unchanged",
                             "Stage 2/Gas=sealed",
                             "Stage 2/Modes=6"});
  double difference = 0;
  for (unsigned int i = 0; i < 6; ++i)
    difference = std::max(
      difference, std::abs(fast[i].frequency() / sealed[i].frequency() - 1));
  check_small("fast air as a sealed gas", difference, 1e-4);
}
