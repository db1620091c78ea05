// SPDX-License-Identifier: LGPL-2.1-or-later

// A bias tire whose stresses relax rolls with the force with which it is
// turned in time over the ground; in slow rolling it is elastic with the moduli
// of long times; and ground and axle have the power that the plies lose.


#include <biface/input/parameter_tools.h>
#include <biface/stepping/step_report.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;

namespace
{
  std::vector<StepReport>
  run(const std::string &cells_around, std::vector<Override> further)
  {
    for (const Override &common :
         std::vector<Override>{"Mesh/Intervals alpha_1=-120:120:10",
                               "Mesh/Intervals alpha_2=" + cells_around,
                               "Contact/Multiplier mass=lumped",
                               "Contact/Friction=0",
                               "Contact/Tread/Height=8",
                               "Contact/Tread/Modulus=1.8",
                               "Number of stages=3",
                               "Stage 2/Steps=2",
                               "Stage 3/Contact=true"})
      further.push_back(common);
    return run_bias_tire(further);
  }

  std::vector<Override>
  relaxing(const std::vector<Override> &further)
  {
    std::vector<Override> all{"Material cord/Relaxation times=1",
                              "Material cord/Relaxation moduli=0.3"};
    all.insert(all.end(), further.begin(), further.end());
    return all;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double                             turn = 2 * dealii::numbers::PI;

  {
    // a turn and a quarter
    const StepReport in_time =
      run("-180:180:48",
          relaxing({"Stage 3/Wheel turn=450",
                    "Stage 3/Duration=" + number_to_string(1.25 * turn),
                    "Stage 3/Steps=60"}))
        .back();
    const StepReport steady =
      run("-180:180:48", relaxing({"Stage 3/Angular velocity=1"})).back();
    check_small("force in time",
                in_time.contact.force - steady.contact.force,
                5e-4,
                steady.contact.force);
    const RollingSummary &rolling = *steady.rolling;
    check_small(
      "balance of powers", rolling.mismatch, 0.03, rolling.hysteresis_power);
    check_small("power of the axle",
                rolling.axle_power - rolling.axle_moment,
                1e-12,
                rolling.axle_power);
    // the pressure moves forward, where its moment resists
    std::cout << "moment of the ground is negative: " << (rolling.moment[1] < 0)
              << std::endl;

    const StepReport backward =
      run("-180:180:48", relaxing({"Stage 3/Angular velocity=-1"})).back();
    check_small("force backward",
                backward.contact.force - steady.contact.force,
                1e-8,
                steady.contact.force);
    check_small("moment backward",
                backward.rolling->moment[1] + rolling.moment[1],
                1e-6,
                rolling.moment[1]);
    check_small("power backward",
                backward.rolling->hysteresis_power - rolling.hysteresis_power,
                1e-8,
                rolling.hysteresis_power);
  }

  {
    const std::string cells = "-180:-40:4, -40:40:12, 40:180:4";
    // relaxed when the ground comes to touch it, too
    const auto slow = run(
      cells,
      relaxing({"Stage 1/Duration=1e16", "Stage 3/Angular velocity=1e-16"}));
    const auto soft = run(cells,
                          {"Material cord/Relaxation times=1",
                           "Material cord/Relaxation moduli=1e-15",
                           "Material cord/E_L=357.315",
                           "Material cord/E_T=4.837",
                           "Material cord/G_LT=1.631",
                           "Material cord/G_TT=1.239"});
    check_small("force in slow rolling",
                slow.back().contact.force - soft.back().contact.force,
                1e-9,
                soft.back().contact.force);
  }
}
