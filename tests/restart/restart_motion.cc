// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is stopped in the middle of an impact with friction, in steps that
// follow the error in time, and continued on another number of ranks has the
// results of a whole one; so has a strip that moves with a mass at its end.

#include "../restart.h"
#include "../tests.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto ring = with({DATA_DIR "/thrown_ring.prm"},
                         {"Supports/alpha_2 min=free",
                          "Supports/alpha_2 max=free",
                          "Contact/Friction=0.3",
                          "Stage 1/Initial velocity=-4000; -3*z; 500+3*x",
                          "Stage 1/Stiffness damping=1e-5",
                          "Stage 1/Time error=0.02",
                          "Stage 1/Duration=0.004"});
  check_restart("impact", ring, 12);

  const auto strip = with({DATA_DIR "/strip_with_mass.prm"},
                          {"Number of stages=2",
                           "Stage 2/Inertia=true",
                           "Stage 2/Forces on bodies=supports: 0",
                           "Stage 2/Load history=supports: 20*sin(400*t)",
                           "Stage 2/Initial velocity=x; 3*y + x; 20*x - x*y",
                           "Material rubber/Density=1e-9",
                           "Stage 2/Stiffness damping=1e-5",
                           "Stage 2/Duration=0.02"});
  check_restart("mass", strip, 20);
}
