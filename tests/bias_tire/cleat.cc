// SPDX-License-Identifier: LGPL-2.1-or-later

// The bias tire on a plane with a bar 40 mm behind the axle, which its tread of
// 8 mm rounds, has the forces of the independent program of doc/bias_tire.md;
// and pressed by a plane that is a body, or by one that moves with the ground,
// it has the force that the ground has.

#include <biface/contact/rigid_body.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/step_report.h>

#include "../model/forces.h"

using namespace Biface;

namespace
{
  using Overrides = std::vector<Override>;

  Overrides
  joined(Overrides first, const Overrides &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }


  double
  height(const Forces &forces)
  {
    return forces.report.loads->ground()->clearance(dealii::Point<3>());
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string file = PRM_DIR "/cleat.prm",
                    tire = PRM_DIR "/bias_tire.prm";
  const Forces behind(
    file,
    {"Mesh/Intervals alpha_2=-180:-15:11:smooth, -15:15:18, 15:180:11:smooth",
     "Stage 3/Steps=4",
     "Body cleat/Motions=pass: 0 0 -170"});
  const auto sum = [&behind](const unsigned int i) {
    return behind.of.at("foundation")[i] + behind.of.at("cleat")[i];
  };
  check_small("vertical", -sum(0) - 2066.2, 5e-5, 2066.2);
  check_small("longitudinal", sum(2) - 37.5, 2e-3, 37.5);
  check_small("balance", behind.imbalance, 1e-9);

  // the same plane three times, on any mesh
  const Overrides   steps{"Mesh/Intervals alpha_1=-120:120:10",
                        "Mesh/Intervals alpha_2=-180:-15:4:smooth, "
                          "-15:15:6, 15:180:4:smooth",
                        "Stage 2/Steps=4",
                        "Contact/Multiplier mass=lumped"};
  const Forces      ground(tire, steps);
  const std::string place =
    "Body road/Point=" + std::to_string(height(ground) + 25) + ", 7, 9";
  const Forces body(tire,
                    joined(steps,
                           {"Bodies=road",
                            place,
                            "Body road/Motions=up: -25 0 0",
                            "Stage 2/Contact=false",
                            "Stage 2/Travel=0",
                            "Stage 2/Bodies=road",
                            "Stage 2/Load factor=1"}));
  const double force = ground.of.at("foundation")[0];
  check_small("body", body.of.at("road")[0] - force, 1e-6, force);
  const Forces carried(tire,
                       joined(steps,
                              {"Bodies=road",
                               "Body road/Moves with=foundation",
                               "Body road/Point=-1, 0, 0",
                               "Stage 2/Bodies=road",
                               "Stage 2/Travel=19"}));
  check_small(
    "moved with the ground", carried.of.at("road")[0] - force, 1e-9, force);
  check_small(
    "which is not there", carried.of.at("foundation")[0], 1e-9, force);
}
