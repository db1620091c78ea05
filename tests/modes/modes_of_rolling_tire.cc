// SPDX-License-Identifier: LGPL-2.1-or-later

// The modes of a tire that hardly spins are those of the tire that stands. If
// it rolls with friction, waves forward and backward differ, and all modes
// decay. Frequencies, growth and shapes do not depend on the number of ranks.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>

#include <biface/solver/modal_analysis.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  VibrationModes
  modes(const std::vector<Override> &changes)
  {
    std::vector<Override> overrides{
      "Material cord/Density=1.2e-9",
      "Mesh/Intervals alpha_1=-120:120:12",
      "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
      "Contact/Multiplier mass=lumped",
      "Stage 2/Travel=12",
      "Stage 2/Steps=1"};
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    const auto reports = run_analysis(PRM_DIR "/bias_tire.prm", overrides);
    return reports.back().modes ? *reports.back().modes : VibrationModes();
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  // pressed without friction
  const auto stands = modes({"Stage 2/Modes=6"});
  const auto creeping =
    modes({"Stage 2/Modes=6", "Stage 2/Angular velocity=1e-4"});
  double deviation = 0;
  for (unsigned int i = 0; i < 6; ++i)
    deviation =
      std::max(deviation,
               std::abs(creeping.modes[i].omega / stands.modes[i].omega - 1.));
  if (root)
    {
      check_small("hardly spinning", deviation, 1e-8);
      check_true("not symmetric", !creeping.symmetric && stands.symmetric);
    }

  const auto rolling = modes({"Contact/Critical velocity=100",
                              "Number of stages=3",
                              "Stage 3/Contact=true",
                              "Stage 3/Friction=0.5",
                              "Stage 3/Ground velocity=5000",
                              "Stage 3/Control=axle moment",
                              "Stage 3/Steps=2",
                              "Stage 3/Modes=10"});
  bool       decays  = true;
  for (const VibrationMode &mode : rolling.modes)
    {
      decays = decays && mode.growth_rate() < 0;
      if (root)
        std::cout << std::setprecision(9) << mode.frequency() << ' '
                  << mode.growth_rate() << ' ' << 1e3 * mode.mass << ' '
                  << mode.participation << ' ' << mode.waves->circumferential
                  << ' ' << mode.waves->travel << std::endl;
    }
  if (root)
    check_true("all decay", decays);
}
