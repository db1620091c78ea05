// SPDX-License-Identifier: LGPL-2.1-or-later

// A wheel that leans over the ground rolls as on ground that leans the other
// way: freely, cornering and braked, also if it leans only from one stage on;
// the ground pushes it to the side to which it leans.

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

namespace
{
  /** The reports at the ends of the stages that roll. */
  std::vector<StepReport>
  roll(std::vector<Override> overrides)
  {
    for (const char *setting :
         {"Mesh/Intervals alpha_1=-120:120:12",
          "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
          "Stage 2/Steps=1",
          "Stage 4/Steps=1",
          "Stage 5/Steps=1"})
      overrides.push_back(setting);
    std::vector<StepReport> ends;
    for (const StepReport &report :
         run_analysis(PRM_DIR "/rolling_tire_at_load.prm", overrides))
      if (report.rolling)
        ends.push_back(report);
    return ends;
  }


  double
  difference(const StepReport &a, const StepReport &b)
  {
    const RollingSummary &x = *a.rolling, &y = *b.rolling;
    return std::max(
      {(x.force - y.force).norm() / y.force.norm(),
       (x.moment - y.moment).norm() / y.moment.norm(),
       std::abs(x.loaded_radius - y.loaded_radius) / y.loaded_radius,
       std::abs(x.rolling_radius - y.rolling_radius) / y.rolling_radius});
  }


  std::string
  direction(const double inclination)
  {
    const double       angle = inclination * dealii::numbers::PI / 180;
    std::ostringstream text;
    text.precision(16);
    text << "Contact/Direction=" << std::cos(angle) << ", " << -std::sin(angle)
         << ", 0";
    return text.str();
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto on_slope = roll({direction(4)});
  const auto leaning  = roll({"Stage 2/Inclination angle=4"});
  const auto later    = roll({"Stage 4/Inclination angle=4"});
  const auto to_left  = roll({"Stage 2/Inclination angle=-4"});
  check_true("three stages roll", on_slope.size() == 3);
  for (unsigned int i = 0; i < on_slope.size(); ++i)
    check_small(on_slope[i].stage, difference(leaning[i], on_slope[i]), 2e-6);
  check_small(
    "leaning from 'cornering' on", difference(later[1], on_slope[1]), 2e-6);
  // standing, without friction: the load is normal to the ground
  const StepReport turned =
    run_analysis(PRM_DIR "/rolling_tire_at_load.prm",
                 {"Mesh/Intervals alpha_1=-120:120:12",
                  "Mesh/Intervals alpha_2=-180:-30:4, -30:30:15, 30:180:4",
                  "Number of stages=2",
                  "Stage 2/Inclination angle=4",
                  "Stage 2/Wheel turn=30"})
      .back();
  check_small("side force of a wheel that has turned",
              force_of_ground(turned.forces_of_bodies).force[1] -
                1900 * std::sin(4 * dealii::numbers::PI / 180),
              1e-6,
              1900);
  check_true("to the right",
             leaning[0].rolling->force[1] < to_left[0].rolling->force[1] - 50);
}
