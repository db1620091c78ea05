// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives of frequencies and buckling factors are refused where the tangent
// is not symmetric, as under pressure that follows a free edge, since shapes
// change them to first order; a pressure of fixed direction allows them.

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
                                "  set E       = 1000\n"
                                "  set Density = 1e-9\n"
                                "end\n"
                                "subsection Supports\n"
                                "  set alpha_1 min = fixed\n"
                                "  set alpha_1 max = v_1 both = -0.001\n"
                                "end\n"
                                "subsection Stage 1\n"
                                "  set Pressure    = 0.001\n"
                                "  set Load factor = 1\n"
                                "  set Modes       = 1\n"
                                "  set Buckling    = 1\n"
                                "end\n"
                                "subsection Sensitivities\n"
                                "  set Entries = Material cord/E\n"
                                "end\n";
  for (const std::string type : {"follower", "dead"})
    for (const std::string output : {"frequency 1", "buckling factor 1"})
      {
        const Ended ended = run({"panel.prm",
                                 "--set",
                                 "Loads/Pressure type=" + type,
                                 "--set",
                                 "Sensitivities/Outputs=" + output},
                                "results",
                                MPI_COMM_SELF);
        std::cout << type << ", " << output << ": exit code " << ended.code
                  << ended.err << std::endl;
      }
}
