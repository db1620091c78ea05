// SPDX-License-Identifier: LGPL-2.1-or-later

// A coarse tire without inertia on drums: on a huge one, cambered and with a
// slip angle, it rolls as on a plane; without friction it rolls with the force
// with which it stands; a drum from which the wheel is steered is one whose
// axis is turned; outside and inside of a drum the powers of free rolling and
// of braking balance but for the error of the mesh, and exactly those of the
// locked wheel.

#include "rolling_wheel.h"

using namespace Biface;

namespace
{
  std::vector<Override>
  on_drum(const std::string           &radius,
          const std::vector<Override> &further = {"Number of stages=3"})
  {
    std::vector<Override> changes{"Contact/Foundation=drum",
                                  "Contact/Drum/Radius=" + radius};
    changes.insert(changes.end(), further.begin(), further.end());
    return changes;
  }


  void
  check_same(const std::string    &what,
             const RollingSummary &a,
             const RollingSummary &b,
             const double          bound)
  {
    const double P = b.force[2];
    std::cout << what << std::endl;
    check_small("  force", (a.force - b.force).norm(), bound, P);
    check_small("  moment", (a.moment - b.moment).norm(), bound, 250 * P);
    check_small(
      "  rolling radius", a.rolling_radius - b.rolling_radius, bound, 250);
    check_small(
      "  power of the ground", a.ground_power - b.ground_power, bound, P);
    check_small(
      "  power of friction", a.friction_power - b.friction_power, bound, P);
  }


  void
  check_braking(const std::string &name, const std::string &radius)
  {
    const RollingRun      tire   = roll(on_drum(radius,
                                         {"Number of stages=4",
                                                 "Stage 4/Contact=true",
                                                 "Stage 4/Friction=0.5",
                                                 "Stage 4/Slip angle=1",
                                                 "Stage 4/Angular velocity=0",
                                                 "Stage 4/Steps=4"}));
    const RollingSummary &free   = tire.rolling[1];
    const RollingSummary &locked = tire.rolling.back();
    std::cout << name << std::endl;
    check_small(
      "  moment of the axle", free.axle_moment, 1e-5, 250 * free.force[2]);
    check_powers("  powers of free rolling", free);
    check_powers("  powers of braking", tire.rolling[2]);
    check_true("  the drum drives",
               locked.ground_power > 0.4 * locked.force[2]);
    check_small("  powers of the locked wheel",
                locked.mismatch,
                1e-8,
                locked.ground_power);
    std::cout << "  vertical force: " << free.force[2] << std::endl
              << "  rolling radius: " << free.rolling_radius << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<Override> cambered{"Number of stages=3",
                                       "Contact/Direction=1, 0.1, 0",
                                       "Contact/Drum/Axis=-0.1, 1, 0",
                                       "Stage 3/Slip angle=2"};
  check_same("a huge drum and a plane",
             roll(on_drum("1e9", cambered)).rolling.back(),
             roll(cambered).rolling.back(),
             1e-6);

  const RollingRun smooth = roll(on_drum("300",
                                         {"Number of stages=3",
                                          "Stage 3/Friction=0",
                                          "Stage 3/Control=load",
                                          "Stage 3/Angular velocity=0.004"}));
  check_small("frictionless force",
              smooth.rolling.back().force[2] - smooth.standing,
              1e-8,
              smooth.standing);
  check_small("frictionless power of the drum",
              smooth.rolling.back().ground_power,
              1e-8,
              smooth.standing);

  // the tangent of 2 degrees; the wheel moves to the left. A node at the middle
  // is the first to touch both
  const std::string mesh =
    "Mesh/Intervals alpha_2=-180:-30:4, -30:30:14, 30:180:4";
  check_same(
    "steered, and on an axis that is turned",
    roll(on_drum("300", {"Number of stages=3", mesh, "Stage 3/Slip angle=2"}))
      .rolling.back(),
    roll(on_drum("300",
                 {"Number of stages=3",
                  mesh,
                  "Contact/Drum/Axis=0, 1, -0.0349207694917477"}))
      .rolling.back(),
    1e-6);

  check_braking("outside of a drum", "300");
  check_braking("inside of a drum", "-600");
}
