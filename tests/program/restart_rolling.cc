// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped while force and axle moment of a rolling wheel are both
// prescribed, and continued on another number of ranks, has the history of an
// uninterrupted run.

#include "restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_restart("force and moment of the axle",
                with(soft_tire,
                     {"Contact/Multiplier mass=lumped",
                      "Contact/Critical velocity=0.05",
                      "Mesh/Intervals alpha_1=-120:120:12",
                      "Mesh/Intervals alpha_2=-180:-30:4, -30:30:13, 30:180:4",
                      "Number of stages=3",
                      "Stage 2/Steps=1",
                      "Stage 2/Travel=12",
                      "Stage 3/Contact=true",
                      "Stage 3/Friction=0.5",
                      "Stage 3/Ground velocity=1",
                      "Stage 3/Control=foundation force and axle moment",
                      "Stage 3/Force=1100",
                      "Stage 3/Axle moment=-20000",
                      "Stage 3/Steps=4",
                      no_vtu}),
                4);
}
