// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped at a bifurcation, and continued on another number of
// ranks, goes on along the other branch as an uninterrupted run.

#include "restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string column = DATA_DIR "/../verification/critical_column.prm";
  check_restart("load", {column}, 5);
  check_restart("arc length",
                {"--set",
                 "Stage 1/Control=arc length",
                 "--set",
                 "Stage 1/Branch amplitude=-5",
                 column},
                4);
}
