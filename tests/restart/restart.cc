// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped under load or displacement control, and continued on
// another number of ranks, has the history of an uninterrupted run.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_restart("loads", soft_tire, 4);
  check_restart("a mesh that no rank holds whole",
                with(soft_tire, {"Mesh/Distribution=distributed", no_vtu}),
                3);
  check_restart(
    "displacement", {DATA_DIR "/../stepping/displacement_control.prm"}, 6);
  const std::vector<std::string> membrane{"--set",
                                          "Stage 2/Steps=3",
                                          "--set",
                                          no_vtu,
                                          PRM_DIR "/prestressed_membrane.prm"};
  check_restart("begin from prestress", membrane, 2);
  check_restart("linear theory", membrane, 4);
  check_restart("after both", membrane, 6);
  check_restart("prestress under follower pressure",
                with(soft_tire,
                     {"Stage 2/Start from prestress=true",
                      "Loads/Pressure type=follower",
                      no_vtu}),
                4);
}
