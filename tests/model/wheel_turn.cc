// SPDX-License-Identifier: LGPL-2.1-or-later

// A tire with equal cells around the axle that turns on a smooth plane by a
// quarter, or back by a cell, has the force with which it stands, along the
// direction of the plane in the axes of the wheel.

#include <cmath>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/quantities/forces_on_shell.h>

#include "rolling_wheel.h"

using namespace Biface;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::vector<dealii::Tensor<1, 3>> forces;
  const auto                        reports = run_analysis(
    PRM_DIR "/bias_tire.prm",
    {"Mesh/Intervals alpha_1=-120:120:12",
                            "Mesh/Intervals alpha_2=-180:180:36",
                            "Number of stages=4",
                            "Stage 2/Steps=2",
                            "Stage 2/Travel=12",
                            "Stage 3/Contact=true",
                            "Stage 3/Wheel turn=90",
                            "Stage 3/Slide=0, 0, -380",
                            "Stage 3/Steps=3",
                            "Stage 4/Start from=2",
                            "Stage 4/Contact=true",
                            "Stage 4/Wheel turn=-10"},
    [&](const ShellEquations &, const StepReport &report, const State &) {
      forces.push_back(force_of_ground(report.forces_of_bodies).force);
    });
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  const double standing = reports[2].contact.force;
  const auto   check    = [&](const std::string &what,
                         const unsigned int step,
                         const double       angle) {
    check_small(
      "force, " + what, reports[step].contact.force - standing, 1e-8, standing);
    const dealii::Tensor<1, 3> direction({std::cos(angle), 0, std::sin(angle)});
    const dealii::Tensor<1, 3> &force = forces[step];
    check_small("its direction",
                ((force - force[1] * dealii::Tensor<1, 3>({0, 1, 0})) +
                 standing * direction)
                  .norm(),
                1e-8,
                standing);
    check_small("side force", force[1] - forces[2][1], 1e-8, standing);
  };
  check_range("standing", standing, 800, 2000);
  check("a quarter", 5, dealii::numbers::PI / 2);
  check("back by a cell", 6, -dealii::numbers::PI / 18);
}
