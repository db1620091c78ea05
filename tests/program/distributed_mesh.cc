// SPDX-License-Identifier: LGPL-2.1-or-later

// A distributed mesh gives the same forces as a mesh shared by all ranks, for
// any number of ranks.

#include <cmath>

#include "../bias_tire/bias_tire.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::vector<Override> coarse{
    "Mesh/Intervals alpha_1=-120:-45:3, -45:45:8, 45:120:3",
    "Mesh/Intervals alpha_2=-180:-15:4:smooth, -15:15:6, 15:180:4:smooth",
    "Stage 2/Travel=10",
    "Stage 2/Steps=2"};
  const auto shared = run_bias_tire(coarse);
  coarse.push_back("Mesh/Distribution=distributed");
  const auto distributed = run_bias_tire(coarse);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  check_true("the same number of steps", shared.size() == distributed.size());
  for (unsigned int i = 0; i < shared.size(); ++i)
    check_small("force",
                shared[i].contact.force - distributed[i].contact.force,
                1e-8,
                std::max(1., std::abs(shared[i].contact.force)));
  check_range("the last one", shared.back().contact.force, 100, 2000);
}
