// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped while force and axle moment of a rolling wheel are both
// prescribed, or later its slip ratio, or while its bristles move on in time,
// with inertia or without it, and continued on another number of ranks, has the
// history of an uninterrupted run.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> rolling =
    with(soft_tire,
         {"Contact/Multiplier mass=lumped",
          "Contact/Critical velocity=0.05",
          "Mesh/Intervals alpha_1=-120:120:12",
          "Mesh/Intervals alpha_2=-180:-30:4, -30:30:13, 30:180:4",
          "Number of stages=4",
          "Stage 2/Steps=1",
          "Stage 2/Travel=12",
          "Stage 3/Contact=true",
          "Stage 3/Friction=0.5",
          "Stage 3/Ground velocity=1",
          "Stage 3/Control=foundation force and axle moment",
          "Stage 3/Force=1100",
          "Stage 3/Steps=2",
          "Stage 4/Contact=true",
          "Stage 4/Friction=0.5",
          "Stage 4/Slip ratio=-0.02",
          "Stage 4/Steps=2",
          no_vtu});
  check_restart("force and moment of the axle", rolling, 4);
  check_restart("slip ratio", rolling, 6);
  const std::vector<std::string> transient =
    with(rolling,
         {"Contact/Rolling friction=bristles",
          "Contact/Regularization=0.3",
          "Contact/Tangential regularization=0.075",
          "Stage 4/Transient rolling=true",
          "Stage 4/Steps=4",
          "Stage 4/Duration=200"});
  check_restart("transient", transient, 6);
  check_restart("with inertia",
                with(transient,
                     {"Material cord/Density=1e-9",
                      "Stage 4/Slip ratio=none",
                      "Stage 4/Duration=0.02",
                      "Stage 4/Inertia=true",
                      "Stage 4/Contact damping=0.5",
                      "Stage 4/Numerical damping=0.5",
                      "Stage 4/Control=axle moment",
                      "Stage 4/Moment of inertia=0.1",
                      "Stage 4/Axle moment=-1000",
                      "Stage 4/Time error=0"}),
                6);
  // the forces at the start of the next stage are those at the end of this one
  check_restart("between two transient stages",
                with(transient,
                     {"Number of stages=5",
                      "Stage 4/Steps=2",
                      "Stage 5/Contact=true",
                      "Stage 5/Friction=0.5",
                      "Stage 5/Transient rolling=true",
                      "Stage 5/Duration=100",
                      "Stage 5/Control=foundation force and axle moment",
                      "Stage 5/Force=1000",
                      "Stage 5/Axle moment=-1000",
                      "Stage 5/Steps=2"}),
                7);
}
