// SPDX-License-Identifier: LGPL-2.1-or-later

// A slip ratio gives the angular velocity (1 + S) V cos(alpha)/R with the
// rolling radius R of the free rolling before, from whose end the stage need
// not start directly; at a slip ratio of 0 the wheel still rolls freely, at -1
// it is locked.

#include <deal.II/base/numbers.h>

#include <cmath>

#include "rolling_wheel.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto  reports = rolling_reports({"Number of stages=6",
                                         "Stage 4/Contact=true",
                                         "Stage 4/Friction=0.5",
                                         "Stage 4/Slip ratio=-0.02",
                                         "Stage 4/Slip angle=2",
                                         "Stage 4/Ground velocity=1.5",
                                         "Stage 5/Contact=true",
                                         "Stage 5/Friction=0.5",
                                         "Stage 5/Slip ratio=-1",
                                         "Stage 5/Steps=4",
                                         "Stage 6/Start from=3",
                                         "Stage 6/Contact=true",
                                         "Stage 6/Friction=0.5",
                                         "Stage 6/Slip ratio=0"});
  const auto &free    = *reports[3].rolling;
  const auto &braked  = reports[4];
  const auto &locked  = reports[8];
  const auto &as_free = *reports[9].rolling;
  check_small("braked",
              braked.level.angular_velocity -
                0.98 * 1.5 * std::cos(2 * dealii::numbers::PI / 180) /
                  free.rolling_radius,
              1e-14);
  check_small(
    "slip ratio of the braked wheel", *braked.slip_ratio + 0.02, 1e-14);
  check_small("of the locked one", *locked.slip_ratio + 1, 1e-14);
  check_true("none before", !reports[3].slip_ratio);
  check_true("it brakes", braked.rolling->axle_moment < 0);
  check_true("locked", locked.level.angular_velocity == 0);
  check_small("still free", as_free.axle_moment, 1e-5, 250 * free.force[2]);
}
