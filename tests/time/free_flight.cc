// SPDX-License-Identifier: LGPL-2.1-or-later

// A free strip under a pulse of forces at three corners tumbles: its energy and
// its position after 50 ms are those of an independent program, and energy,
// momentum and angular momentum are constant.

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
  check_small("energy", motion.energy.back() - energy, 1e-9, energy);
  check_constants(motion, "free", 1e-11);
  for (unsigned int i = 0; i < 3; ++i)
    check_small("displacement",
                number(motion.probes.back(), std::string("u_") + "xyz"[i]) -
                  displacement[i],
                1e-7);
}
