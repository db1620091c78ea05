// SPDX-License-Identifier: LGPL-2.1-or-later

// prm/rolling_tire_at_load.prm on a coarse mesh rolls under the prescribed
// force in all steps: without a moment of the axle, freely and at a slip angle,
// which pushes the wheel back into its plane; and with the slip ratio that
// brakes it.

#include <biface/model/quantities/rolling_summary.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto reports =
    run_analysis(PRM_DIR "/rolling_tire_at_load.prm",
                 {"Mesh/Intervals alpha_1=-120:120:12",
                  "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
                  "Stage 2/Steps=1"});

  double other_force = 0, axle_moment = 0;
  for (const StepReport &report : reports)
    if (report.rolling)
      {
        other_force =
          std::max(other_force, std::abs(report.rolling->force[2] - 1900));
        if (report.stage != "braking")
          axle_moment =
            std::max(axle_moment, std::abs(report.rolling->axle_moment));
      }
  check_small("vertical force", other_force, 1e-6, 1900);
  check_small("moment of the axle", axle_moment, 1e-6, 250 * 1900.);

  const auto last_of = [&](const std::string &stage) {
    StepReport last;
    for (const StepReport &report : reports)
      if (report.stage == stage)
        last = report;
    return last;
  };
  const StepReport free      = last_of("free");
  const StepReport cornering = last_of("cornering");
  const StepReport braking   = last_of("braking");
  check_range("rolling radius", free.rolling->rolling_radius, 230, 250);
  check_range("force of the slip angle",
              free.rolling->force[1] - cornering.rolling->force[1],
              300,
              900);
  check_small("slip ratio", *braking.slip_ratio + 0.02, 1e-12);
  check_range("drag of braking", -braking.rolling->force[0], 300, 950);
}
