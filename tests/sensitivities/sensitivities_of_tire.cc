// SPDX-License-Identifier: LGPL-2.1-or-later

// The derivatives of the force on the bias tire, pressed by 20 mm from where
// the plane touches the inflated tire, are those of the independent
// program of doc/bias_tire.md: by the pressure, by the angle of all plies and
// by the travel. Those by the pressure and all moduli together agree with the
// homogeneity of the equations, and none depends on the number of ranks: the
// last table, in millionths, is the same to 1e-8.

#include <deal.II/base/mpi.h>

#include <iomanip>
#include <iostream>

#include <biface/stepping/sensitivity_table.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string moduli =
    "Material cord/E_L, Material cord/E_T, Material cord/G_LT, "
    "Material cord/G_TT, Contact/Regularization";
  const auto reports = run_analysis(
    PRM_DIR "/bias_tire.prm",
    {"Contact/Multiplier mass=lumped",
     "Stage 2/Steps=2",
     "Newton/Residual tolerance=1e-11",
     "Named points=crown: 0 -180",
     "Sensitivities/Entries=p: Stage 1/Pressure, Stage 2/Pressure;"
     "gamma: Laminate/Plies[2], -Laminate/Plies[4], Laminate/Plies[6], "
     "-Laminate/Plies[8]; Stage 2/Travel;"
     "scale: factor of Stage 1/Pressure, Stage 2/Pressure, " +
       moduli + ";Surface/Circular arc/Radius",
     "Sensitivities/Outputs=force, max_pressure, footprint_area, "
     "loaded_radius, crown u_x"});
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  const SensitivityTable &table = *reports.back().sensitivities;
  const auto             &d     = table.derivatives;
  check_small("dP/dp", d[0][0] - 7505.9, 0.05);
  check_small("dP/dgamma", d[1][0] - 1.9968, 1e-4);
  check_small("dP/dDelta", d[2][0] - 129.61, 0.005);
  // forces scale with them, displacements do not change
  check_small("force by scale", table.logarithmic(3, 0) - 1, 1e-6);
  check_small("pressure by scale", table.logarithmic(3, 1) - 1, 1e-6);
  for (const unsigned int o : {2, 3, 4})
    check_small(
      table.outputs[o].name + " by scale", table.logarithmic(3, o), 1e-6);

  std::cout << std::setprecision(10);
  for (const unsigned int e : {0, 1, 2, 4})
    for (unsigned int o = 0; o < table.outputs.size(); ++o)
      std::cout << table.outputs[o].name << " by " << table.entries[e].name
                << ": " << 1e6 * table.logarithmic(e, o) << std::endl;
}
