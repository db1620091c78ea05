// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarse tire without inertia: without friction it rolls with the force with
// which it stands; rolling backwards turns its ply steer around; with plies in
// mirror symmetry it rolls without a side force; the powers of free rolling and
// of braking balance but for the error of the mesh; and the force on the locked
// wheel is mu P but for the critical velocity. It has a rolling resistance, the
// same backwards, which no friction needs, but none if it is locked.

#include "rolling_wheel.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  const RollingRun tire   = roll({"Number of stages=4",
                                  "Stage 4/Contact=true",
                                  "Stage 4/Friction=0.5",
                                  "Stage 4/Angular velocity=0",
                                  "Stage 4/Steps=4"});
  const RollingRun smooth = roll({"Number of stages=3",
                                  "Stage 3/Friction=0",
                                  "Stage 3/Control=load",
                                  "Stage 3/Angular velocity=0.004",
                                  "Stage 3/Slip angle=3"});
  const RollingRun back =
    roll({"Number of stages=3", "Stage 3/Ground velocity=-1"});
  // cords across the wheel are their own mirror images
  const RollingRun mirrored =
    roll({"Number of stages=3", "Laminate/Plies=cord: 4.8 @ 0"});
  if (!is_root)
    return 0;

  const RollingSummary &free   = tire.rolling[1];
  const RollingSummary &locked = tire.rolling.back();
  check_small("frictionless force",
              smooth.rolling.back().force[2] - smooth.standing,
              1e-8,
              smooth.standing);
  check_small(
    "frictionless drag", smooth.rolling.back().force[0], 1e-8, smooth.standing);
  check_small(
    "moment of the axle", free.axle_moment, 1e-5, 250 * free.force[2]);
  check_range("rolling radius", free.rolling_radius, 240, 250);
  check_true("drag", free.force[0] < 0);
  check_range("ply steer", std::abs(free.force[1]) / free.force[2], 0.01, 0.2);
  check_small("side force backwards",
              back.rolling[1].force[1] + free.force[1],
              1e-6,
              free.force[2]);
  check_small("rolling radius backwards",
              back.rolling[1].rolling_radius - free.rolling_radius,
              1e-6,
              250);
  check_small("side force with mirrored plies",
              mirrored.rolling[1].force[1],
              1e-7,
              free.force[2]);
  check_powers("powers of free rolling", free);
  check_powers("powers of braking", tire.rolling[2]);
  check_small("force of the locked wheel",
              std::hypot(locked.force[0], locked.force[1]) -
                0.5 * locked.force[2],
              1e-3,
              0.5 * locked.force[2]);
  check_small("rolling resistance backwards",
              back.rolling[1].rolling_resistance - free.rolling_resistance,
              1e-6,
              free.rolling_resistance);
  check_range("power of the hysteresis without friction",
              smooth.rolling.back().rolling_resistance /
                free.rolling_resistance,
              0.7,
              1.3);
  check_small("rolling resistance of the locked wheel",
              locked.rolling_resistance,
              1e-15,
              free.rolling_resistance);
  std::cout << "rolling resistance: " << free.rolling_resistance << std::endl;
  std::cout << "vertical force: " << free.force[2] << std::endl
            << "drag of the braked wheel: " << tire.rolling[2].force[0]
            << std::endl;
}
