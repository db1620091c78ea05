// SPDX-License-Identifier: LGPL-2.1-or-later

// The force at 20 mm converges with order two to that of the independent
// program of doc/bias_tire.md, 1878 N: extrapolated from 42 x 40 and 84 x 80
// elements it is within 2 N of it.

#include "../tests.h"
#include "bias_tire.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto coarse =
    run_bias_tire({"Stage 2/Steps=1", "Contact/Multiplier mass=lumped"});
  // the ratio of neighboring cells is the square root of that of the coarse
  // mesh, so that the fine mesh has all of its lines
  const auto fine = run_bias_tire(
    {"Stage 2/Steps=1",
     "Contact/Multiplier mass=lumped",
     "Mesh/Coarse meshes=1",
     "Mesh/Intervals alpha_1=-120:-45:24, -45:45:36, 45:120:24",
     "Mesh/Intervals alpha_2=-180:-15:22:0.8615898602201, -15:15:36, "
     "15:180:22:1.1606450425781"});

  const double first  = coarse.back().contact.force,
               second = fine.back().contact.force;
  check_range("force on the coarse mesh", first, 1929, 1930);
  check_range("extrapolated force", second + (second - first) / 3, 1876, 1880);
}
