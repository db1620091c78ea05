// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped in the middle of a stage with friction, or with nodes
// that are glued, and continued on another number of ranks, has the results of
// a whole one.

#include "../restart.h"
#include "../tests.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto slid = with(soft_tire,
                         {no_vtu,
                          "Stage 2/Steps=2",
                          "Contact/Multiplier mass=lumped",
                          "Contact/Regularization=1e2",
                          "Newton/Residual tolerance=1e-11",
                          "Number of stages=3",
                          "Stage 3/Contact=true",
                          "Stage 3/Slide=0, 4, 1",
                          "Stage 3/Turn=0.5",
                          "Stage 3/Steps=4"});
  check_restart("friction", with(slid, {"Contact/Friction=0.4"}), 6);
  check_restart(
    "points in cells",
    with(slid, {"Contact/Friction=0.4", "Contact/Points in cells=2"}),
    6);
  check_restart("glued", with(slid, {"Stage 3/Glued=true"}), 6);
}
