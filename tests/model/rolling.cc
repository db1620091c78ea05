// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarse tire without inertia: without friction it rolls with the force with
// which it stands; rolling backwards turns its ply steer around; with plies in
// mirror symmetry it rolls without a side force; the powers of free rolling and
// of braking balance but for the error of the mesh; and the force on the locked
// wheel is mu P but for the critical velocity. It has a rolling resistance, the
// same backwards, which no friction needs, but none if it is locked.

#include <biface/model/rolling_summary.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

namespace
{
  struct Run
  {
    /** The vertical force of the wheel at rest. */
    double                      standing = 0;
    std::vector<RollingSummary> rolling;
  };


  Run
  roll(const std::vector<Override> &changes)
  {
    std::vector<Override> overrides{
      "Contact/Multiplier mass=lumped",
      "Contact/Critical velocity=0.02",
      "Material cord/Loss factor=0.1",
      "Mesh/Intervals alpha_1=-120:120:12",
      "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
      "Stage 2/Steps=1",
      "Stage 2/Travel=12",
      "Stage 3/Contact=true",
      "Stage 3/Friction=0.5",
      "Stage 3/Ground velocity=1",
      "Stage 3/Control=axle moment",
      "Stage 3/Steps=2"};
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    Run run;
    for (const StepReport &report :
         run_analysis(PRM_DIR "/bias_tire.prm", overrides))
      if (report.rolling)
        run.rolling.push_back(*report.rolling);
      else
        run.standing = report.contact.force;
    return run;
  }


  void
  check_powers(const std::string &what, const RollingSummary &rolling)
  {
    check_small(what,
                rolling.mismatch,
                0.005,
                std::abs(rolling.force[0]) + rolling.force[2]);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  const Run tire   = roll({"Number of stages=4",
                           "Stage 4/Contact=true",
                           "Stage 4/Friction=0.5",
                           "Stage 4/Angular velocity=0",
                           "Stage 4/Steps=4"});
  const Run smooth = roll({"Number of stages=3",
                           "Stage 3/Friction=0",
                           "Stage 3/Control=load",
                           "Stage 3/Angular velocity=0.004",
                           "Stage 3/Slip angle=3"});
  const Run back   = roll({"Number of stages=3", "Stage 3/Ground velocity=-1"});
  // cords across the wheel are their own mirror images
  const Run mirrored =
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
