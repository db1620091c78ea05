// SPDX-License-Identifier: LGPL-2.1-or-later

// A tire that spins faster and faster gets one warning, which names its largest
// cells, when the tangent has negative pivots.

#include <biface/contact/rolling.h>
#include <biface/model/state/loads.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Analysis   analysis(PRM_DIR "/bias_tire.prm",
                    {"Mesh/Intervals alpha_1=-120:120:8",
                       "Material cord/Density=1.2e-9",
                       "Stage 2/Contact=false",
                       "Stage 2/Travel=unchanged",
                       "Stage 2/Angular velocity=300",
                       "Stage 2/Steps=15"});
  double     stable = 0, unstable = 1e9;
  const auto result =
    analysis.simulation.run([&](const StepReport &report, const State &) {
      if (!report.loads->rolling)
        return;
      const double speed = report.loads->rolling->angular_velocity;
      if (report.n_negative_pivots.value_or(0) == 0)
        stable = std::max(stable, speed);
      else
        unstable = std::min(unstable, speed);
    });
  check_true("the run is complete", result.success);
  check_true("negative pivots from some speed on", stable + 1 < unstable);

  const std::string text = analysis.screen.str(), warning = "  Warning: ";
  const auto        found = text.find(warning);
  check_true("a warning", found != std::string::npos);
  check_true("one only", found == text.rfind(warning));
  std::cout << "from " << unstable << " on:" << std::endl
            << text.substr(found, text.find('\n', found) - found) << std::endl;
}
