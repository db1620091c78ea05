// SPDX-License-Identifier: LGPL-2.1-or-later

// prm/rolling_resistance.prm on a coarse mesh: the drag is the power that its
// plies lose, over the speed, but for friction and an error of the mesh, and
// their heat reduces it.

#include <algorithm>

#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  StepReport
  run(const std::string &temperatures)
  {
    return run_analysis(
             PRM_DIR "/rolling_resistance.prm",
             {"Mesh/Intervals alpha_1=-120:-45:3, -45:45:8, 45:120:3",
              "Heat/Temperatures=" + temperatures,
              "Number of stages=3",
              "Stage 3/Ground velocity=10000"})
      .back();
  }

  double
  highest_temperature(const StepReport &report)
  {
    double highest = 0;
    for (const double T : report.heat->temperature)
      highest = std::max(highest, T);
    return highest;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const StepReport coupled = run("coupled"), computed = run("computed");
  for (const StepReport &report : {coupled, computed})
    check_small("drag",
                report.rolling->force[0] + report.rolling->rolling_resistance,
                0.07,
                report.rolling->rolling_resistance);
  check_true("heated plies resist less",
             coupled.rolling->rolling_resistance <
               0.9 * computed.rolling->rolling_resistance);
  check_true("and are less hot than without this effect",
             highest_temperature(coupled) < highest_temperature(computed));
  check_true("hotter than the gas inside", highest_temperature(coupled) > 35);
}
