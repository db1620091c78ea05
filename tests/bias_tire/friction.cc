// SPDX-License-Identifier: LGPL-2.1-or-later

// Slid sideways by 5 mm with the coefficient of friction 0.5, the bias tire has
// the lateral force of the independent program of doc/bias_tire.md within
// 0.1 %, and slips in about half of its footprint; with the coefficient 0.1 it
// slips everywhere, and the force is the coefficient times the vertical one.

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  dealii::Tensor<1, 3> force;
  const auto           reports = run_bias_tire(
    {"Contact/Multiplier mass=lumped",
               "Number of stages=4",
               "Stage 2/Steps=2",
               "Stage 3/Contact=true",
               "Stage 3/Friction=0.5",
               "Stage 3/Slide=0, 5, 0",
               "Stage 3/Steps=5",
               "Stage 4/Contact=true",
               "Stage 4/Friction=0.1",
               "Stage 4/Slide=0, 15, 0",
               "Stage 4/Steps=2"},
    [&](const ShellEquations &, const StepReport &report, const State &) {
      force = force_of_ground(report.forces_of_bodies).force;
      if (report.step == 8)
        check_small("lateral force", force[1] - 692.7, 1e-3, 692.7);
    });
  const ContactSummary &at_5_mm = reports[7].contact;
  check_range("nodes in contact", at_5_mm.n_nodes, 299, 301);
  check_range("nodes that slip", at_5_mm.n_slipping, 150, 170);
  const ContactSummary &last = reports.back().contact;
  check_true("all slip at the end", last.n_slipping == last.n_nodes);
  check_small("force of full sliding",
              std::hypot(force[1], force[2]) - 0.1 * last.force,
              1e-4,
              0.1 * last.force);
}
