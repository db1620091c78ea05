// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped while a wheel is turned on rough ground, where its
// nodes stick and slip by their history, and continued on another number of
// ranks, has the history of an uninterrupted run, which contains the turn.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_restart("turned wheel",
                with(soft_tire,
                     {"Contact/Multiplier mass=lumped",
                      "Contact/Friction=0.5",
                      "Mesh/Intervals alpha_1=-120:120:10",
                      "Mesh/Intervals alpha_2=-180:180:36",
                      "Newton/Residual tolerance=1e-10",
                      "Number of stages=3",
                      "Stage 2/Steps=2",
                      "Stage 2/Travel=12",
                      "Stage 3/Contact=true",
                      "Stage 3/Wheel turn=12",
                      "Stage 3/Slide=0, 2, -50",
                      "Stage 3/Steps=4",
                      no_vtu}),
                6);
  if (!is_root())
    return 0;

  const auto rows = read_table("whole/history.csv");
  const auto column =
    std::find(rows[0].begin(), rows[0].end(), "wheel_turn") - rows[0].begin();
  for (const unsigned int step : {3, 4, 7})
    std::cout << "turn after step " << step << ": " << rows.at(step).at(column)
              << std::endl;
}
