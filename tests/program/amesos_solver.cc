// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver through Amesos gives the forces of MUMPS, on one rank and
// on two.

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
  const auto mumps = run_bias_tire(coarse);
  coarse.push_back("Linear solver/Type=Amesos");
  const auto amesos = run_bias_tire(coarse);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  check_true("three steps", mumps.size() == 3 && amesos.size() == 3);
  check_range("force", mumps.back().contact.force, 100, 2000);
  check_small("difference",
              mumps.back().contact.force - amesos.back().contact.force,
              1e-8,
              mumps.back().contact.force);
}
