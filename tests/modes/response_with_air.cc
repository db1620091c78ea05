// SPDX-License-Identifier: LGPL-2.1-or-later

// The force of the wheel on a pressed tire and its air, which the ground
// shakes, is that of the ground on the tire if the wheel shakes it, with an air
// wave between both. It does not depend on the number of ranks.

#include <cmath>
#include <iomanip>

#include <biface/solver/harmonic_response.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // vectors that are interpolated move rigidly without strain
  const auto reports =
    run_analysis(PRM_DIR "/bias_tire.prm",
                 {"Material cord/Density=1.2e-9",
                  "Formulation=vertices",
                  "Mesh/Intervals alpha_1=-120:120:10",
                  "Mesh/Intervals alpha_2=-180:-30:5, -30:30:10, 30:180:5",
                  "Loads/Pressure type=follower",
                  "Contact/Friction=0.8",
                  "Gas/Ambient pressure=0.1",
                  "Gas/Sound speed=343000",
                  "Stage 2/Travel=15",
                  "Stage 2/Steps=1",
                  "Stage 2/Loss factor=0.01",
                  "Stage 2/Frequency response=60, 245, 270",
                  "Stage 2/Excitations=ground x, ground z, supports x, "
                  "supports z"});
  const FrequencyResponse &response = *reports.back().response;
  const unsigned int       n        = response.outputs.size();
  // alpha_1 min, alpha_1 max, foundation, rim on air
  double largest = 0;
  for (unsigned int f = 0; f < response.frequencies.size(); ++f)
    for (unsigned int e = 0; e < 2; ++e)
      {
        const unsigned int         d         = 2 * e;
        const auto                &by_ground = response.values[f][e];
        const std::complex<double> wheel     = by_ground[n - 4][d] +
                                           by_ground[n - 3][d] +
                                           by_ground[n - 1][d],
                                   ground = response.values[f][2 + e][n - 2][d];
        largest = std::max(largest, std::abs(wheel / ground - 1.));
      }
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      check_small("reciprocity", largest, 1e-6);
      std::cout << std::setprecision(9);
      for (unsigned int f = 0; f < response.frequencies.size(); ++f)
        std::cout << response.frequencies[f] << ": "
                  << response.values[f][1][n - 1][2] << std::endl;
    }
}
