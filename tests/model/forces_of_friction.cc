// SPDX-License-Identifier: LGPL-2.1-or-later

// On a rough ground of each shape that slides and turns, for both
// mortar matrices, the forces and moments on a tire are in balance, and that
// of the ground along its direction is the force of the history.

#include <biface/stepping/step_report.h>

#include "forces.h"

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  for (const std::string mass : {"lumped", "consistent"})
    for (const std::string shape : {"plane", "drum", "sphere"})
      {
        const Forces forces(
          PRM_DIR "/bias_tire.prm",
          {"Mesh/Intervals alpha_1=-120:120:14",
           "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,"
           "20:180:4:smooth",
           "Contact/Multiplier mass=" + mass,
           "Contact/Foundation=" + shape,
           "Contact/Drum/Radius=1000",
           "Contact/Sphere/Radius=1000",
           "Contact/Friction=0.4",
           "Stage 2/Steps=2",
           "Stage 2/Travel=15",
           "Newton/Residual tolerance=1e-11",
           "Number of stages=3",
           "Stage 3/Contact=true",
           "Stage 3/Slide=0, 4, 2",
           "Stage 3/Turn=1",
           "Stage 3/Steps=2"});
        if (!is_root)
          continue;
        std::cout << shape << ", " << mass << " mortar matrix" << std::endl;
        const double force = forces.report.contact.force;
        check_true("  some nodes slip", forces.report.contact.n_slipping > 0);
        check_small("  balance", forces.imbalance, 1e-8);
        check_small("  force of the ground",
                    forces.of.at("foundation")[0] + force,
                    1e-9,
                    force);
      }
}
