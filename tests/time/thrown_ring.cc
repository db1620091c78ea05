// SPDX-License-Identifier: LGPL-2.1-or-later

// A ring that is thrown at a plane: the plane, which stands still, does no work
// and contact without friction dissipates nothing. With damping, restitution
// and the part of the energy that is dissipated are those of an independent
// program. With friction and contact damping, energy and work balance.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "motion.h"

using namespace dealii;

namespace
{
  double
  largest(const Motion &motion, const std::string &column)
  {
    double result = 0;
    for (const Row &row : motion.history)
      result = std::max(result, std::abs(number(row, column)));
    return result;
  }


  Motion
  run_ring(const std::string &name, const std::vector<std::string> &settings)
  {
    std::vector<std::string> words{DATA_DIR "/thrown_ring.prm"};
    words.insert(words.end(), settings.begin(), settings.end());
    std::cout << name << '\n';
    const Motion motion = move(words, "ring", MPI_COMM_SELF);
    check_balance(motion, 1e-12);
    return motion;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // half of the ring
  const double mass = 1.2e-9 * numbers::PI * 100 * 5 * 20, speed = 4000,
               energy  = mass * speed * speed / 2;
  const Motion elastic = run_ring("elastic", {});
  check_small("energy", elastic.energy.back() - energy, 2e-3, energy);
  check_small(
    "work of the plane", largest(elastic, "foundation_work"), 1e-12, energy);
  check_small(
    "dissipated in contact", largest(elastic, "contact_work"), 1e-10, energy);
  check_range("restitution",
              number(elastic.history.back(), "momentum_x") / mass / speed,
              0.729,
              0.761);

  const Motion damped = run_ring("damped", {"Stage 1/Stiffness damping=2e-4"});
  check_small("restitution",
              number(damped.history.back(), "momentum_x") / mass / speed -
                0.6711,
              2e-3);
  check_small("dissipated",
              number(damped.history.back(), "damping_work") / energy - 0.254,
              1e-3);

  const Motion rough =
    run_ring("friction",
             {"Contact/Friction=0.4",
              "Stage 1/Initial velocity=-4000; -3*z; 500+3*(x-40)",
              "Stage 1/Contact damping=0.5",
              "Supports/alpha_2 min=free",
              "Supports/alpha_2 max=free",
              "Stage 1/Duration=0.012"});
  check_small(
    "work of the plane", largest(rough, "foundation_work"), 1e-12, energy);
  for (const std::string column : {"friction_work", "contact_work"})
    {
      bool   grows = true;
      double last  = 0;
      for (const Row &row : rough.history)
        {
          grows = grows && number(row, column) >= last - 1e-9 * energy;
          last  = number(row, column);
        }
      check_true(column + " grows", grows && last > 1e-4 * energy);
    }
}
