// SPDX-License-Identifier: LGPL-2.1-or-later

// An inflated hose between two walls presses with the pressure times the width
// along which a membrane lies flat, (L - pi g)/2 with the length L of its
// section and the distance g of its middle lines, less some percent for the
// bending of the wall; and a door that slides along it is dragged by the
// coefficient of friction times this force.

#include "forces.h"

using namespace Biface;


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Forces forces(PRM_DIR "/inflatable_seal.prm", {});
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  const double pi = dealii::numbers::PI, width = 30000 * 0.002 * pi / 180;
  // cords of 237 N/mm are stretched by p (g - h)/2
  const double pressure = 0.5, distance = 18.8,
               length = 82.2 * (1 + pressure * (distance - 1.2) / 2 / 237) + 10,
               expected = pressure * (length - pi * distance) / 2 * width;
  const auto &door      = forces.of.at("door");
  check_small("force", -door[1] - expected, 0.05, expected);
  check_small(
    "drag", std::hypot(door[0], door[2]) + 0.2 * door[1], 1e-4, -0.2 * door[1]);
  check_small("balance", forces.imbalance, 1e-8);
}
