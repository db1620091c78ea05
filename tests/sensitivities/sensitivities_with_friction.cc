// SPDX-License-Identifier: LGPL-2.1-or-later

// With friction, derivatives do not depend on the number of ranks either,
// although the round-off in the positions of nodes matters: logarithmic ones,
// here times 100, are the same to 1e-8, also those of the pressure at a node.

#include <deal.II/base/mpi.h>

#include "sensitivities.h"

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const SensitivityTable table = table_of(
    PRM_DIR "/bias_tire.prm",
    {"Mesh/Intervals alpha_1=-120:120:16",
     "Mesh/Intervals alpha_2=-180:-30:5:smooth,-30:30:8,30:180:5:smooth",
     "Contact/Multiplier mass=lumped",
     "Contact/Tangential regularization=100",
     "Stage 2/Friction=0.5",
     "Stage 2/Steps=2",
     "Newton/Residual tolerance=1e-11",
     "Sensitivities/Entries=p: Stage 1/Pressure, Stage 2/Pressure;"
     "Stage 2/Travel; Material cord/E_L; Material cord/G_LT",
     "Sensitivities/Outputs=force, footprint_area, max_pressure, "
     "foundation F_x"});
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    print_logarithmic(table);
}
