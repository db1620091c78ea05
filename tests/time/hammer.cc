// SPDX-License-Identifier: LGPL-2.1-or-later

// A ring at rest is hit by a rigid body with a mass, a plane or a sphere: the
// momentum of both together stays, and so does the energy, with what friction
// dissipates. A force on the body changes the momentum by its impulse.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "motion.h"

using namespace dealii;

namespace
{
  constexpr double mass = 2e-5, speed = 3000;


  /** Check momentum and energy after a hit.
   * @param impulse that of forces on the body, by the time. */
  template <typename Function>
  void
  check_hit(const std::string              &name,
            const std::vector<std::string> &settings,
            const Function                 &impulse)
  {
    std::cout << name << '\n';
    std::vector<std::string> words{
      DATA_DIR "/thrown_ring.prm",
      "Bodies=hammer",
      "Body hammer/Point=-103, 0, 0",
      "Body hammer/Direction=-1, 0, 0",
      "Body hammer/Motions=fly: 1 0 0",
      "Body hammer/Masses=fly: 2e-5",
      "Stage 1/Contact=false",
      "Stage 1/Bodies=hammer",
      "Stage 1/Forces on bodies=hammer fly: 0",
      "Stage 1/Initial velocity=",
      "Stage 1/Initial velocities of bodies=hammer fly: 3000",
      "Stage 1/Duration=0.01"};
    words.insert(words.end(), settings.begin(), settings.end());
    const Motion motion = move(words, "hammer", MPI_COMM_SELF);
    check_balance(motion, 1e-11);
    double velocity = speed, place = 0, time = 0, deviation = 0, start = 0;
    for (const Row &row : motion.history)
      {
        const double t = number(row, "time"), u = number(row, "hammer_u_x");
        velocity = 2 * (u - place) / (t - time) - velocity;
        start += impulse((t + time) / 2) * (t - time);
        place     = u;
        time      = t;
        deviation = std::max(deviation,
                             std::abs(number(row, "momentum_x") +
                                      mass * velocity - mass * speed - start));
      }
    check_small("momentum", deviation, 1e-8, mass * speed);
    check_true("is hit",
               number(motion.history.back(), "momentum_x") >
                 0.1 * mass * speed);
    check_small(
      "energy",
      motion.energy.back() + number(motion.history.back(), "friction_work") +
        number(motion.history.back(), "contact_work") -
        number(motion.history.back(), "load_work") - mass * speed * speed / 2,
      1e-9,
      mass * speed * speed);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto none = [](const double) { return 0.; };
  check_hit("plane", {}, none);
  check_hit("sphere with friction, beside the center",
            {"Body hammer/Shape=sphere",
             "Body hammer/Radius=30",
             "Body hammer/Point=-132.6, 20, 10",
             "Body hammer/Friction=0.3",
             "Supports/alpha_2 min=free",
             "Supports/alpha_2 max=free"},
            none);
  check_hit("plane with a force",
            {"Stage 1/Load history=hammer fly: 3*sin(300*t)"},
            [](const double t) { return 3 * std::sin(300 * t); });
}
