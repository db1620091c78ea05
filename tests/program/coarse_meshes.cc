// SPDX-License-Identifier: LGPL-2.1-or-later

// Beginning on a coarser mesh changes how many iterations there are, not where
// they end.

#include <cmath>

#include "../bias_tire/bias_tire.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // a given travel, then a given force
  std::vector<Override> settings{
    "Mesh/Intervals alpha_1=-120:-45:4, -45:45:12, 45:120:4",
    "Mesh/Intervals alpha_2=-180:-15:6:smooth, -15:15:12, 15:180:6:smooth",
    "Number of stages=3",
    "Stage 2/Travel=12",
    "Stage 2/Steps=1",
    "Stage 3/Name=force",
    "Stage 3/Pressure=0.15",
    "Stage 3/Contact=true",
    "Stage 3/Control=foundation force",
    "Stage 3/Force=1200",
    "Stage 3/Steps=1"};
  const auto alone = run_bias_tire(settings);
  settings.push_back("Mesh/Coarse meshes=1");
  const auto nested = run_bias_tire(settings);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  check_true("three steps", alone.size() == 3 && nested.size() == 3);
  unsigned int n_alone = 0, n_nested = 0;
  for (unsigned int i = 0; i < 3; ++i)
    {
      check_small(
        "force", nested[i].contact.force - alone[i].contact.force, 1e-6, 1000.);
      check_small(
        "approach", nested[i].approach - alone[i].approach, 1e-6, 10.);
      n_alone += alone[i].iterations;
      n_nested += nested[i].iterations;
    }
  check_true("fewer iterations", n_nested < n_alone);
  check_range("force at 12 mm", nested[1].contact.force, 800, 1300);
  check_small("given force", nested[2].contact.force - 1200, 1e-6, 1200.);
}
