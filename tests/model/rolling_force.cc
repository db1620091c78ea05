// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarse tire whose force on the ground and moment of the axle are both
// prescribed, with travel and angular velocity unknown, rolls with the travel
// and the angular velocity of a run in which the travel is prescribed: freely
// on a plane, and braked on a drum.


#include <biface/input/parameter_tools.h>

#include "rolling_wheel.h"

using namespace Biface;

namespace
{
  void
  test(const std::string &name, const std::vector<Override> &ground)
  {
    const auto last_of = [&](const std::vector<Override> &changes) {
      std::vector<Override> all(ground);
      all.insert(all.end(), changes.begin(), changes.end());
      return rolling_reports(all).back();
    };
    const StepReport given = last_of({"Number of stages=3"});
    const double     force = given.contact.force;
    const StepReport found =
      last_of({"Number of stages=3",
               "Stage 2/Travel=0.5",
               "Stage 3/Control=foundation force and axle moment",
               "Stage 3/Force=" + number_to_string(force)});
    std::cout << name << std::endl;
    check_small("  force", found.contact.force - force, 1e-6, force);
    check_small("  moment of the axle",
                found.rolling->axle_moment - given.rolling->axle_moment,
                2e-6,
                250 * force);
    check_small("  travel", found.level.travel - given.level.travel, 1e-5, 12);
    check_small("  angular velocity",
                found.level.angular_velocity - given.level.angular_velocity,
                1e-6,
                given.level.angular_velocity);
    check_small("  side force",
                found.rolling->force[1] - given.rolling->force[1],
                1e-5,
                force);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test("free on a plane", {});
  test("braked on a drum",
       {"Contact/Foundation=drum",
        "Contact/Drum/Radius=300",
        "Stage 3/Slip angle=1",
        "Stage 3/Axle moment=-30000"});
}
