// SPDX-License-Identifier: LGPL-2.1-or-later

// A run in which stresses relax, that is stopped in the middle of a stage or
// after stages that branch, and continued on another number of ranks, has the
// results of a whole one.

#include "../restart.h"
#include "../tests.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto relaxing = with(soft_tire,
                             {no_vtu,
                              "Stage 2/Steps=2",
                              "Contact/Multiplier mass=lumped",
                              "Newton/Residual tolerance=1e-11",
                              "Number of stages=3",
                              "Stage 1/Duration=0.5",
                              "Stage 2/Duration=2",
                              "Stage 3/Contact=true",
                              "Stage 3/Duration=3",
                              "Stage 3/Steps=4",
                              "Material cord/Relaxation times=1, 20",
                              "Material cord/Relaxation moduli=0.2, 0.3"});
  check_restart("linear law", relaxing, 6);
  check_restart("branched", with(relaxing, {"Stage 3/Start from=1"}), 6);
}
