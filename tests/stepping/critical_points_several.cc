// SPDX-License-Identifier: LGPL-2.1-or-later

// A step that passes more than four critical points gives their number: those
// of Euler's column are at (2 k - 1)^2 times the first load, five of them below
// 100 times that load.

#include "../restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ended ended = run({DATA_DIR "/../verification/critical_column.prm",
                           "--set",
                           "Number of stages=2",
                           "--set",
                           "Stage 1/Load factor=1",
                           "--set",
                           "Stage 1/Steps=1",
                           "--set",
                           "Stage 1/Critical points=report",
                           "--set",
                           "Stage 2/Load factor=205.6",
                           "--set",
                           "Stage 2/Steps=1"},
                          "results",
                          MPI_COMM_SELF);
  std::cout << "exit code " << ended.code << ended.err << std::endl;
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);)
    if (line.find("negative pivots:") != std::string::npos)
      std::cout << line << std::endl;
}
