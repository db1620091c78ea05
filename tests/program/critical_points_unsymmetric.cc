// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the tangent is not symmetric, as under pressure on a shell with a free
// edge, the program says that it cannot locate critical points.

#include "restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ofstream("panel.prm") << "subsection Surface\n"
                                "  set Type = plane\n"
                                "end\n"
                                "subsection Mesh\n"
                                "  set Intervals alpha_1 = 0:10:4\n"
                                "  set Intervals alpha_2 = 0:10:4\n"
                                "  set Closed in alpha_2 = false\n"
                                "end\n"
                                "subsection Material cord\n"
                                "  set E = 1000\n"
                                "end\n"
                                "subsection Supports\n"
                                "  set alpha_1 min = fixed\n"
                                "end\n"
                                "subsection Stage 1\n"
                                "  set Pressure = 0.01\n"
                                "  set Critical points = locate\n"
                                "  set Steps = 2\n"
                                "end\n";
  for (const std::string type : {"follower", "dead"})
    {
      const Ended ended =
        run({"panel.prm", "--set", "Loads/Pressure type=" + type},
            "results",
            MPI_COMM_SELF);
      std::cout << type << ": exit code " << ended.code << ended.err
                << std::endl;
      std::istringstream lines(ended.out);
      for (std::string line; std::getline(lines, line);)
        if (line.find("Warning") != std::string::npos)
          std::cout << line << std::endl;
    }
}
