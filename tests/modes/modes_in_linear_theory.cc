// SPDX-License-Identifier: LGPL-2.1-or-later

// After a stage with linear strain theory, modes contain its stresses: a string
// that it stretches has the frequencies k/(2 L) sqrt(sigma/rho), which change
// as the square root of the displacement of its end.

#include <string>

#include <biface/solver/modal_analysis.h>
#include <biface/stepping/sensitivity_table.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // the stress is 1: E = 100, length 1, no initial stresses
  const StepReport report =
    run_analysis(
      DATA_DIR "/../verification/modes_string.prm",
      {"Laminate/Initial ply stresses=",
       "Supports/alpha_1 max=v_1 both = 0.01; v_2 middle; v_3 middle",
       "Stage 1/Strain theory=linear",
       "Stage 1/Load factor=1",
       "Sensitivities/Entries=end: Supports/alpha_1 max",
       "Sensitivities/Outputs=frequency 1, frequency 2"})
      .back();
  for (unsigned int k = 1; k <= 2; ++k)
    {
      const std::string name = "frequency " + std::to_string(k);
      check_small(
        name, report.modes->modes[k - 1].frequency() / (0.5 * k) - 1, 2e-3);
      check_small("its logarithmic derivative by the displacement",
                  report.sensitivities->logarithmic(0, k - 1) - 0.5,
                  2e-4);
    }
}
