// SPDX-License-Identifier: LGPL-2.1-or-later

// A restart knows the stages whose derivatives are left out, since their linear
// systems were not solved: also with more iterations, sensitivities.csv is that
// of an uninterrupted run.

#include "../restart.h"
#include "../too_few_iterations.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<std::string> tire{PRM_DIR "/bias_tire.prm"};
  const auto                     too_few = with(tire, too_few_iterations(55));
  std::filesystem::remove_all("whole");
  std::cout << "whole: " << run(too_few, "whole", MPI_COMM_SELF).code << '\n';
  for (const std::string step : {"4", "5"})
    {
      std::filesystem::remove_all("cut");
      const int stopped =
        run(too_few, "cut", MPI_COMM_SELF, "Step " + step + ",").code;
      const int continued =
        restart(with(tire, too_few_iterations(300)), "cut", MPI_COMM_SELF).code;
      std::cout << "cut in step " << step << ": " << stopped << ", "
                << continued << '\n';
      check_small(
        "  derivatives", difference("sensitivities.csv", "whole", "cut"), 1e-9);
    }
}
