// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped at a bifurcation, and continued on another number of
// ranks, goes on along the other branch as an uninterrupted run, also if its
// only checkpoint is that of the stop.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> column =
    with({DATA_DIR "/../verification/critical_column.prm"},
         {"Mesh/Intervals alpha_1=0:100:12"});
  check_restart("load", with(column, {"Checkpoint/Every steps=0"}), 5);
  check_restart(
    "arc length",
    with(column, {"Stage 1/Control=arc length", "Stage 1/Branch amplitude=-5"}),
    4);
}
