// SPDX-License-Identifier: LGPL-2.1-or-later

// At the frequency 0 the response of a tire that rolls with friction is the
// derivative of its steady forces by the travel of the ground and by the
// pressure. It does not depend on the number of ranks at any frequency.

#include <cmath>
#include <iomanip>

#include <biface/solver/harmonic_response.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  std::vector<StepReport>
  run(const std::vector<Override> &changes)
  {
    std::vector<Override> overrides{
      "Material cord/Density=1.2e-9",
      "Mesh/Intervals alpha_1=-120:120:10",
      "Mesh/Intervals alpha_2=-180:-30:4, -30:30:12, 30:180:4",
      "Contact/Multiplier mass=lumped",
      "Contact/Critical velocity=300",
      "Newton/Residual tolerance=1e-11",
      "Newton/Update tolerance=1e-12",
      "Number of stages=4",
      "Stage 2/Travel=12",
      "Stage 2/Steps=1",
      "Stage 3/Contact=true",
      "Stage 3/Friction=0.5",
      "Stage 3/Ground velocity=5000",
      "Stage 3/Angular velocity=20",
      "Stage 3/Slip angle=2",
      "Stage 3/Steps=2",
      "Stage 4/Contact=true",
      "Stage 4/Friction=0.5"};
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    return run_analysis(PRM_DIR "/bias_tire.prm", overrides);
  }


  Tensor<1, 3>
  ground(const StepReport &report)
  {
    return force_of_ground(report.forces_of_bodies).force;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  constexpr double change = 1e-4;
  const auto       moved =
    run({"Stage 3/Frequency response=0, 40",
         "Stage 3/Excitations=ground x, ground y, supports x, pressure",
         "Stage 4/Travel=" + std::to_string(12 + change)});
  const auto pumped =
    run({"Stage 4/Pressure=" + std::to_string(0.15 + change)});
  const unsigned int       last     = moved.size() - 2;
  const FrequencyResponse &response = *moved[last].response;
  const unsigned int       n        = response.outputs.size() - 1;

  const Tensor<1, 3> before = ground(moved[last]);
  // the ground travels against its x axis
  const Tensor<1, 3> by_travel   = (before - ground(moved.back())) / change,
                     by_pressure = (ground(pumped.back()) - before) / change;
  double of_travel = 0, of_pressure = 0, of_slide = 0;
  for (unsigned int d = 0; d < 3; ++d)
    {
      const auto by = [&](const unsigned int excitation) {
        return response.values[0][excitation][n][d].real();
      };
      of_travel   = std::max(of_travel, std::abs(by(0) - by_travel[d]));
      of_pressure = std::max(of_pressure, std::abs(by(3) - by_pressure[d]));
      // rolling on as before beside the old track
      of_slide = std::max(of_slide, std::abs(by(1)));
    }
  if (root)
    {
      check_small("by the travel", of_travel, 1e-4, by_travel.norm());
      check_small("by the pressure", of_pressure, 1e-4, by_pressure.norm());
      check_small("by a slide", of_slide, 1e-8, by_travel.norm());
      std::cout << std::setprecision(8);
      for (unsigned int e = 0; e < response.excitations.size(); ++e)
        std::cout << response.excitations[e] << ": "
                  << response.values[1][e][n][0] << std::endl;
    }
}
