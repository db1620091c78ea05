// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives of frequencies and buckling factors are refused where the tangent
// is not symmetric, as under pressure that follows a free edge, since shapes
// change them to first order; a pressure of fixed direction allows them.

#include "restart.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> panel =
    with({DATA_DIR "/panel_with_free_edges.prm"},
         {"Supports/alpha_1 max=v_1 both = -0.001",
          "Stage 1/Pressure=0.001",
          "Stage 1/Load factor=1",
          "Stage 1/Modes=1",
          "Stage 1/Buckling=1",
          "Sensitivities/Entries=Material cord/E"});
  for (const std::string type : {"follower", "dead"})
    for (const std::string output : {"frequency 1", "buckling factor 1"})
      {
        const Ended ended = run(with(panel,
                                     {"Loads/Pressure type=" + type,
                                      "Sensitivities/Outputs=" + output}),
                                "results",
                                MPI_COMM_SELF);
        std::cout << type << ", " << output << ": exit code " << ended.code
                  << said(ended) << std::endl;
      }
}
