// SPDX-License-Identifier: LGPL-2.1-or-later

// The rolling bias tire has the figures of the independent program of
// doc/bias_tire.md: of free rolling, at one degree of slip angle, and braked,
// with a critical velocity of 0.01 of the speed, and of 0.001, where a step
// from standing to rolling converges that cannot be halved; and, without
// friction, the vertical force at 100 radians per second. Braking, the powers
// balance within 0.5 %.

#include <biface/model/quantities/rolling_summary.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto reports = run_bias_tire({"Contact/Multiplier mass=lumped",
                                      "Contact/Critical velocity=0.01",
                                      "Step control/Maximum cuts=0",
                                      "Number of stages=7",
                                      "Stage 2/Steps=2",
                                      "Stage 3/Contact=true",
                                      "Stage 3/Friction=0.5",
                                      "Stage 3/Ground velocity=1",
                                      "Stage 3/Control=axle moment",
                                      "Stage 3/Steps=4",
                                      "Stage 4/Contact=true",
                                      "Stage 4/Friction=0.5",
                                      "Stage 4/Slip angle=1",
                                      "Stage 4/Control=axle moment",
                                      "Stage 5/Start from=3",
                                      "Stage 5/Contact=true",
                                      "Stage 5/Friction=0.5",
                                      "Stage 5/Angular velocity=0.00414370",
                                      "Stage 6/Start from=2",
                                      "Stage 6/Contact=true",
                                      "Stage 6/Friction=0.5",
                                      "Stage 6/Ground velocity=10",
                                      "Stage 6/Control=axle moment",
                                      "Stage 7/Contact=true",
                                      "Stage 7/Friction=0.5",
                                      "Stage 7/Slip angle=1",
                                      "Stage 7/Control=axle moment"});
  const auto check   = [&](const std::string &what,
                         const double       value,
                         const double       expected,
                         const double       bound) {
    check_small(what, value - expected, bound, expected);
  };
  const RollingSummary free = *reports[6].rolling;
  check("rolling radius", free.rolling_radius, 238.915, 2e-5);
  check("vertical force", free.force[2], 1899.5, 1e-4);
  check("drag", -free.force[0], 6.26, 0.02);
  check("ply steer", -free.force[1], 86.5, 0.005);
  check("side force at 1 degree", -reports[7].rolling->force[1], 627.1, 0.005);
  const RollingSummary braked = *reports[8].rolling;
  check("braking force", -braked.force[0], 342.3, 0.01);
  check_small("powers of braking", braked.mismatch, 0.005, -braked.force[0]);

  std::cout << "steps: " << reports.size() << std::endl;
  check("rolling radius at 0.001",
        reports[9].rolling->rolling_radius,
        238.646,
        1e-4);
  check("side force at 0.001 and 1 degree",
        -reports[10].rolling->force[1],
        676.96,
        0.005);

  const auto spinning = run_bias_tire({"Contact/Multiplier mass=lumped",
                                       "Material cord/Density=1.2e-9",
                                       "Number of stages=3",
                                       "Stage 2/Steps=2",
                                       "Stage 3/Contact=true",
                                       "Stage 3/Angular velocity=100",
                                       "Stage 3/Steps=4"});
  check("vertical force at 100 radians per second",
        spinning.back().contact.force,
        2171.0,
        1e-3);
}
