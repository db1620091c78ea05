// SPDX-License-Identifier: LGPL-2.1-or-later

// A run whose stages branch, stopped within a branch and continued on another
// number of ranks, has the results of an uninterrupted run. A stage can start
// from the end of an earlier one at a restart only if this end was kept.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto words = with(soft_tire,
                          {no_vtu,
                           "Contact/Tangential regularization=100",
                           "Stage 2/Travel=10",
                           "Stage 2/Steps=1",
                           "Number of stages=5",
                           "Stage 3/Contact=true",
                           "Stage 3/Friction=0.5",
                           "Stage 3/Slide=0, 2, 0",
                           "Stage 3/Steps=2",
                           "Stage 4/Start from=2",
                           "Stage 4/Contact=true",
                           "Stage 4/Glued=true",
                           "Stage 4/Turn=1",
                           "Stage 4/Steps=2",
                           "Stage 5/Start from=2",
                           "Stage 5/Contact=true",
                           "Stage 5/Travel=12"});
  check_restart("stopped before the branches", words, 4);
  if (is_root())
    check_small(
      "  stiffnesses", difference("stiffness.csv", "whole", "cut"), 1e-7);
  check_restart("stopped within a branch", words, 6);

  if (is_root())
    for (const std::string stage : {"3", "2"})
      {
        const Ended ended = restart(with(words,
                                         {"Number of stages=6",
                                          "Stage 6/Start from=" + stage,
                                          "Stage 6/Contact=true",
                                          "Stage 6/Travel=9"}),
                                    "cut",
                                    MPI_COMM_SELF);
        std::cout << "another branch, from stage " << stage << ": "
                  << ended.code << '\n'
                  << said(ended);
      }
}
