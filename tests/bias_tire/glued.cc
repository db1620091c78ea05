// SPDX-License-Identifier: LGPL-2.1-or-later

// The stiffnesses of the bias tire, pressed by 20 mm without friction and then
// glued to the plane, agree with those of the independent program of
// doc/bias_tire.md within 0.1 %: lateral (with the longitudinal force by which
// a bias tire couples the two), longitudinal and torsional.

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  /** What the ground exerts on the tire at the end. */
  ForceOnShell
  ground_on(const std::vector<Override> &motion)
  {
    std::vector<Override> overrides{"Contact/Multiplier mass=lumped",
                                    "Contact/Tangential regularization=1e4",
                                    "Number of stages=3",
                                    "Stage 2/Steps=2",
                                    "Stage 3/Contact=true",
                                    "Stage 3/Glued=true"};
    overrides.insert(overrides.end(), motion.begin(), motion.end());
    ForceOnShell result;
    run_bias_tire(
      overrides,
      [&](const ShellEquations &, const StepReport &report, const State &) {
        result = force_of_ground(report.forces_of_bodies);
      });
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double step    = 0.01;
  const auto   lateral = ground_on({"Stage 3/Slide=0, 0.01, 0"});
  check_small("vertical force", lateral.force[0] + 1929.45, 1e-5, 1929.45);
  check_small(
    "lateral stiffness", lateral.force[1] / step - 145.24, 1e-3, 145.24);
  check_small("longitudinal force per lateral displacement",
              lateral.force[2] / step + 12.87,
              1e-3,
              12.87);
  const auto longitudinal = ground_on({"Stage 3/Slide=0, 0, 0.01"});
  check_small("longitudinal stiffness",
              longitudinal.force[2] / step - 1049.6,
              1e-3,
              1049.6);
  check_small("lateral force per longitudinal displacement",
              longitudinal.force[1] / step + 12.87,
              1e-3,
              12.87);
  const auto turn = ground_on({"Stage 3/Turn=0.01"});
  check_small(
    "torsional stiffness", turn.moment[0] / step - 58655, 1e-3, 58655);
}
