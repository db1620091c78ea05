// SPDX-License-Identifier: LGPL-2.1-or-later

// prm/slip_step.prm on 8 x 24 cells: the side force of a wheel that is turned
// grows over the way that an independent program needs, and ends as in steady
// rolling. It hardly depends on the part of a cell that particles pass in a
// step (there it does, by the first node that touches). A wheel whose axle has
// no moment, and a load that is given, change little. A moment that comes in no
// time ends as in steady rolling, too.

#include <cmath>

#include <biface/model/quantities/rolling_summary.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  constexpr double way = 1500.72;

  std::vector<double>
  side_forces(const std::vector<Override> &more)
  {
    std::vector<Override> overrides{
      "Mesh/Intervals alpha_1=-120:-50:2, -50:50:4, 50:120:2",
      "Mesh/Intervals alpha_2=-180:-30:6, -30:30:12, 30:180:6",
      "Contact/Tread/Height=none",
      "Contact/Tread/Modulus=0",
      "Contact/Regularization=0.3",
      "Contact/Tangential regularization=0.075",
      "Loads/Pressure type=dead",
      "Stage 5/Duration=" + std::to_string(way / 10000)};
    overrides.insert(overrides.end(), more.begin(), more.end());
    std::vector<double> result;
    for (const StepReport &report :
         run_analysis(PRM_DIR "/slip_step.prm", overrides))
      if (report.rolling && report.stage != "free")
        result.push_back(report.rolling->force[1]);
    return result;
  }

} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto steady = [](const std::string &angle) {
    return side_forces({"Number of stages=4",
                        "Stage 4/Transient rolling=false",
                        "Stage 4/Slip angle=" + angle})
      .back();
  };
  const double small = steady("0.1"), large = steady("1");
  const auto   of_cells = [&](const std::string &angle, const double cells) {
    return side_forces(
      {"Stage 4/Slip angle=" + angle,
       "Stage 5/Steps=" + std::to_string(std::lround(72 / cells))});
  };

  const auto forces = of_cells("1", 1);
  check_small("end at 1 degree", forces.back() - large, 1e-4, large);
  check_small("length at 1 degree",
              relaxation_length(forces, large, way) - 180,
              0.04,
              180);
  check_small("at 0.1 degrees",
              relaxation_length(of_cells("0.1", 1), small, way) - 220.2,
              0.05,
              220.2);
  check_small("in steps of four cells",
              relaxation_length(of_cells("0.1", 4), small, way) - 231.0,
              0.05,
              231.0);
  check_small("of half a cell",
              relaxation_length(of_cells("0.1", 0.5), small, way) - 220.2,
              0.05,
              220.2);

  const auto free =
    side_forces({"Stage 4/Control=foundation force and axle moment",
                 "Stage 4/Force=1974.88",
                 "Stage 5/Control=foundation force and axle moment",
                 "Stage 5/Force=1974.88",
                 "Stage 5/Steps=36"});
  check_small("with a given load and a free axle",
              relaxation_length(free, free.back(), way) -
                relaxation_length(forces, large, way),
              0.05,
              relaxation_length(forces, large, way));
  // which turns the wheel at thousands of radians per second in no time
  const std::vector<Override> braked{"Stage 4/Slip angle=1",
                                     "Stage 4/Control=axle moment",
                                     "Stage 4/Axle moment=-20000"};
  std::vector<Override>       at_once = braked, held = braked;
  at_once.insert(at_once.end(),
                 {"Number of stages=4", "Stage 4/Transient rolling=false"});
  held.insert(held.end(),
              {"Stage 5/Control=axle moment",
               "Stage 5/Axle moment=-20000",
               "Stage 5/Steps=24"});
  const double end = side_forces(at_once).back();
  check_small("a moment in no time", side_forces(held).back() - end, 1e-3, end);
}
