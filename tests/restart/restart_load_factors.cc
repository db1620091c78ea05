// SPDX-License-Identifier: LGPL-2.1-or-later

// A run in which loads have factors of their own, stopped in the second stage
// and continued on another number of ranks, has the history and the derivatives
// of an uninterrupted run; stages may be added that name other loads.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> strip{
    "--set",
    "Loads/Edge forces=alpha_2 max: 0 0 1e-5, alpha_2 max: 1e-4 0 0",
    "--set",
    "Stage 2/Load factors=supports alpha_1 max v_3: 1, edge forces: 0.5",
    DATA_DIR "/compressed_strip.prm"};
  check_restart("two factors",
                with(strip,
                     {"Sensitivities/Entries=Stage 1/Load factors; a: Stage "
                      "2/Load factors[1]; b: Stage 2/Load factors[2]",
                      "Sensitivities/Outputs=alpha_1 max F_z, middle u_z",
                      "Sensitivities/Relative step=0.03"}),
                5);
  const std::vector<std::string> longer =
    with(strip,
         {"Number of stages=3",
          "Stage 3/Start from=1",
          "Stage 3/Load factors=edge forces alpha_2 max 2: 1, supports: 0.9",
          "Stage 3/Load factor=0.2",
          "Stage 3/Start from prestress=true",
          "Stage 3/Steps=2"});
  check_restart("a branch from prestress", longer, 8);

  // only the first run knows nothing of the names in the last stage
  if (is_root())
    {
      std::filesystem::remove_all("whole");
      std::filesystem::remove_all("cut");
      const auto chain = with(longer, {"Stage 3/Start from=2"});
      run(chain, "whole", MPI_COMM_SELF);
      std::cout << "first: "
                << run(with(chain, {"Number of stages=2"}),
                       "cut",
                       MPI_COMM_SELF,
                       "Step 5,")
                     .code
                << '\n';
      std::cout << "more stages: " << restart(chain, "cut", MPI_COMM_SELF).code
                << '\n';
      check_small("  history", difference("history.csv", "whole", "cut"), 1e-9);
      check_small("  forces", difference("forces.csv", "whole", "cut"), 1e-8);
      std::cout << said(
        restart(with(chain, {"Stage 3/Load factors=supports: 1"}),
                "cut",
                MPI_COMM_SELF));
    }
}
