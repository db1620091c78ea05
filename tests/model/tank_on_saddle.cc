// SPDX-License-Identifier: LGPL-2.1-or-later

// The saddle of a tank that nothing else holds carries the weight of the water,
// pi R^2 L rho g.

#include "forces.h"

using namespace Biface;


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Forces forces(PRM_DIR "/saddle_tank.prm",
                      {"Mesh/Intervals alpha_1=0:150:5, 150:300:5, 300:4000:15",
                       "Mesh/Intervals alpha_2=0:50:20, 50:70:16, 70:180:22",
                       "Named points="});
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  const double weight = dealii::numbers::PI * 1e6 * 4000 * 9.81e-6 / 2,
               saddle = -forces.of.at("saddle")[0];
  check_small("weight", saddle - weight, 2e-3, weight);
  check_small("balance", saddle - forces.of.at("loads")[0], 1e-8, weight);
}
