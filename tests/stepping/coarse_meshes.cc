// SPDX-License-Identifier: LGPL-2.1-or-later

// Starting from a coarser mesh changes the number of iterations but not the
// results.


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
    "Stage 2/Travel=18",
    "Stage 2/Steps=1",
    "Stage 3/Name=force",
    "Stage 3/Pressure=0.15",
    "Stage 3/Contact=true",
    "Stage 3/Control=foundation force",
    "Stage 3/Force=2000",
    "Stage 3/Steps=1"};
  const auto alone = run_bias_tire(settings);
  settings.push_back("Mesh/Coarse meshes=1");
  const auto nested = run_bias_tire(settings);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  check_true("three steps", alone.size() == 3 && nested.size() == 3);
  for (unsigned int i = 0; i < 3; ++i)
    {
      check_small(
        "force", nested[i].contact.force - alone[i].contact.force, 1e-6, 1000.);
      check_small(
        "approach", nested[i].level.travel - alone[i].level.travel, 1e-6, 10.);
    }
  check_true("fewer iterations to the given travel",
             nested[1].iterations < alone[1].iterations);
  check_range("force at 18 mm", nested[1].contact.force, 1600, 2100);
  check_small("given force", nested[2].contact.force - 2000, 1e-6, 2000.);
}
