// SPDX-License-Identifier: LGPL-2.1-or-later

// The tensions of a thin strap around a drum that turns under it have the ratio
// exp(mu theta), Euler's, with mu/(1 + h/(2 R)) for the friction at the face,
// in both directions, and the moment of the drum is their difference times R +
// h/2.

#include "forces.h"

using namespace Biface;


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double pi = dealii::numbers::PI, radius = 100.1;
  for (const double friction : {0.1, 0.3})
    for (const int stages : {2, 3})
      {
        // less along the way of the drum, more against it
        const int    sign = stages == 2 ? -1 : 1;
        const Forces forces(PRM_DIR "/band_brake.prm",
                            {"Mesh/Intervals alpha_2=0:180:90",
                             "Body drum/Friction=" + std::to_string(friction),
                             "Number of stages=" + std::to_string(stages)});
        if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
          continue;
        const double ratio   = std::exp(sign * friction * pi / (1 + 0.1 / 100)),
                     tension = -forces.of.at("alpha_2 min")[2];
        check_small("tension", tension - ratio, 2e-4, ratio);
        check_small("moment",
                    forces.of.at("drum")[4] - (1 - tension) * radius,
                    1e-5,
                    radius);
        check_small("balance", forces.imbalance, 1e-6);
      }
}
