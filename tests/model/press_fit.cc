// SPDX-License-Identifier: LGPL-2.1-or-later

// A conical ring that is pushed onto a cone expands by the travel times tan 5,
// and the axial force is the radial one, 2 pi int E t w/R ds, times
// tan(5 + atan mu), without and with friction.

#include "press_fit.h"

#include "forces.h"

using namespace Biface;


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const double friction : {0., 0.2, 0.5})
    {
      const Forces forces(DATA_DIR "/press_fit.prm",
                          {"Body cone/Friction=" + std::to_string(friction)});
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      const double expected = press_fit_force(friction);
      check_small(
        "axial force", -forces.of.at("cone")[1] - expected, 5e-4, expected);
      check_small("balance", forces.imbalance, 1e-9);
    }
}
