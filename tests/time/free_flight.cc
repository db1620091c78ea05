// SPDX-License-Identifier: LGPL-2.1-or-later

// A free strip under a pulse of forces at three corners tumbles: its energy and
// its position after 50 ms are those of an independent program, and energy,
// momentum and angular momentum are constant. The mean of the velocities of a
// point at the ends of a step is its displacement over the step.

#include <deal.II/base/mpi.h>

#include <array>

#include "motion.h"

using namespace dealii;


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double                energy = 22820.8342486653;
  const std::array<double, 3> displacement{
    {-200.63200861, 72.08451469, 429.03075001}};
  const Motion motion =
    move({DATA_DIR "/tumbling_strip.prm"}, "strip", MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  const auto n_probes  = motion.probes.size() / motion.history.size();
  double     deviation = 0, fastest = 0;
  for (unsigned int k = 1; k < motion.history.size(); ++k)
    for (const std::string axis : {"x", "y", "z"})
      {
        const auto at = [&](const unsigned int step, const std::string &what) {
          return number(motion.probes[n_probes * step], what + axis);
        };
        const double time = number(motion.history[k], "time") -
                            number(motion.history[k - 1], "time");
        deviation = std::max(deviation,
                             std::abs((at(k, "v_") + at(k - 1, "v_")) / 2 -
                                      (at(k, "u_") - at(k - 1, "u_")) / time));
        fastest   = std::max(fastest, std::abs(at(k, "v_")));
      }
  check_small("velocities", deviation, 1e-7, fastest);
  check_small("energy", motion.energy.back() - energy, 1e-9, energy);
  check_constants(motion, "free", 1e-11);
  for (unsigned int i = 0; i < 3; ++i)
    check_small("displacement",
                number(motion.probes.back(), std::string("u_") + "xyz"[i]) -
                  displacement[i],
                1e-7);
}
