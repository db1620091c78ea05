// SPDX-License-Identifier: LGPL-2.1-or-later

// A stage that says nothing of pressure, load factor or travel keeps them.

#include <biface/model/state/loads.h>
#include <biface/stepping/step_report.h>

#include "../bias_tire/bias_tire.h"
#include "../tests.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto steps = run_bias_tire({"Mesh/Intervals alpha_1=-120:120:8",
                                    "Mesh/Intervals alpha_2=-180:180:12",
                                    "Number of stages=3",
                                    "Stage 1/Load factor=0.5",
                                    "Stage 2/Pressure=unchanged",
                                    "Stage 2/Travel=5",
                                    "Stage 2/Steps=1",
                                    "Stage 3/Contact=true"});
  check_true("three steps", steps.size() == 3);
  for (const StepReport &step : steps)
    std::cout << step.loads->pressure << ' ' << step.loads->factors[0] << ' '
              << step.level.travel << std::endl;
  check_small("force",
              steps.back().contact.force - steps[1].contact.force,
              1e-6,
              steps[1].contact.force);
}
