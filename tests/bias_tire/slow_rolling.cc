// SPDX-License-Identifier: LGPL-2.1-or-later

// A bias tire that is turned slowly over the ground, in steps of a fifth of a
// cell, with nodes that stick and slip by their history, has the vertical force
// and, within 2 %, the side force of steady rolling at a slip angle of 2
// degrees.

#include <cmath>

#include <biface/input/parameter_tools.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>
#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  const std::vector<Override> mesh{
    "Mesh/Intervals alpha_1=-120:-45:4, -45:45:8, 45:120:4",
    "Mesh/Intervals alpha_2=-180:-41.25:6:smooth, -41.25:41.25:22, "
    "41.25:180:6:smooth",
    "Contact/Friction=0.5",
    "Number of stages=4",
    "Stage 2/Friction=0",
    "Stage 2/Steps=2",
    "Stage 3/Contact=true",
    "Stage 4/Contact=true"};

  std::vector<Override>
  with(const std::vector<Override> &further)
  {
    std::vector<Override> all(mesh);
    all.insert(all.end(), further.begin(), further.end());
    return all;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  constexpr double       degree  = dealii::numbers::PI / 180;
  constexpr unsigned int n_cells = 7;
  // the angle of the point of the wheel that is lowest at the start
  constexpr double start = -18.75, cell = 3.75, turn = n_cells * cell;

  const RollingSummary steady =
    *run_bias_tire(with({"Contact/Multiplier mass=lumped",
                         "Contact/Critical velocity=0.001",
                         "Stage 3/Ground velocity=1",
                         "Stage 3/Control=axle moment",
                         "Stage 3/Steps=5",
                         "Stage 4/Slip angle=2",
                         "Stage 4/Control=axle moment",
                         "Stage 4/Steps=4"}))
       .back()
       .rolling;

  const double way    = steady.rolling_radius * turn * degree;
  const auto   vector = [](const double x, const double y, const double z) {
    return number_to_string(x) + ", " + number_to_string(y) + ", " +
           number_to_string(z);
  };
  const double cosine = std::cos(start * degree),
               sine   = std::sin(start * degree);
  // the side force is near its final value after a slide by 7 mm
  constexpr double     slide = -7;
  dealii::Tensor<1, 3> force;
  const StepReport     slow =
    run_bias_tire(
      with({"Contact/Multiplier mass=lumped",
            "Contact/Direction=" + vector(cosine, 0, sine),
            "Stage 3/Slide=" + vector(0, slide, 0),
            "Stage 3/Steps=4",
            "Stage 4/Wheel turn=" + number_to_string(turn),
            "Stage 4/Slide=" + vector(way * sine,
                                      slide - way * std::tan(2 * degree),
                                      -way * cosine),
            "Stage 4/Steps=" + std::to_string(5 * n_cells)}),
      [&](const ShellEquations &, const StepReport &report, const State &) {
        force = force_of_ground(report.forces_of_bodies).force;
      })
      .back();

  check_small("vertical force",
              slow.contact.force - steady.force[2],
              2e-3,
              steady.force[2]);
  check_small("side force", force[1] - steady.force[1], 0.02, -steady.force[1]);
}
