// SPDX-License-Identifier: LGPL-2.1-or-later

// Under a given force, no entry but the force itself changes the force, and the
// derivatives of the approach and of pressures do not depend on the number of
// ranks: logarithmic ones, here times 100, are the same to 1e-8.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "sensitivities.h"
#include <tests.h>


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const SensitivityTable table = table_of(
    PRM_DIR "/bias_tire.prm",
    {"Mesh/Intervals alpha_1=-120:120:14",
     "Mesh/Intervals alpha_2=-180:-20:4:smooth, -20:20:6, 20:180:4:smooth",
     "Contact/Multiplier mass=lumped",
     "Stage 2/Control=foundation force",
     "Stage 2/Force=500",
     "Stage 2/Travel=unchanged",
     "Stage 2/Steps=2",
     "Newton/Residual tolerance=1e-11",
     "Sensitivities/Entries=p: Stage 1/Pressure, Stage 2/Pressure;"
     "Material cord/E_L; Laminate/Plies[2]; Stage 2/Force",
     "Sensitivities/Outputs=force, approach, max_pressure, footprint_area"});
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  for (unsigned int e = 0; e < table.entries.size(); ++e)
    {
      const bool is_force = (table.entries[e].name == "Stage 2/Force");
      check_small("force by " + table.entries[e].name,
                  std::abs(table.logarithmic(e, 0) - (is_force ? 1 : 0)),
                  1e-8);
    }
  print_logarithmic(table, 1);
}
