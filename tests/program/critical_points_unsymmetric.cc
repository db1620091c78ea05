// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the tangent is not symmetric, as under pressure on a shell with a free
// edge, the program says that it cannot locate critical points.

#include "restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> panel =
    with({DATA_DIR "/panel_with_free_edges.prm"},
         {"Stage 1/Critical points=locate", "Stage 1/Steps=2"});
  for (const std::string type : {"follower", "dead"})
    {
      const Ended ended = run(
        with(panel, {"Loads/Pressure type=" + type}), "results", MPI_COMM_SELF);
      std::cout << type << ": exit code " << ended.code << said(ended)
                << std::endl;
      std::istringstream lines(ended.out);
      for (std::string line; std::getline(lines, line);)
        if (line.find("Warning") != std::string::npos)
          std::cout << line << std::endl;
    }
}
