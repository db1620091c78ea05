// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives by factors of loads and supports are those of whole runs with a
// changed factor, under given loads and under a controlled displacement.

#include <deal.II/base/mpi.h>

#include "sensitivities.h"


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string strip = DATA_DIR "/compressed_strip.prm";
  check_sensitivities("supports",
                      strip,
                      {"Loads/Edge forces=alpha_2 max: 0 0 1e-5",
                       "Stage 2/Load factors=supports alpha_1 max v_3: 1, "
                       "edge forces: 0.5"},
                      "Stage 1/Load factors; a: Stage 2/Load factors[1]; b: "
                      "Stage 2/Load factors[2]; Supports/alpha_1 max[1]; "
                      "Material strip/E",
                      "alpha_1 max F_z, alpha_1 min F_x, middle u_z");
  check_sensitivities(
    "displacement",
    strip,
    {"Supports/alpha_1 max=v_1 both = -0.005; v_2 both",
     "Loads/Edge forces=alpha_1 max: 0 0 1, alpha_2 max: 0 0 1e-5",
     "Stage 1/Load factors=supports: 1",
     "Stage 2/Control=displacement",
     "Stage 2/Control point=end",
     "Stage 2/Control component=z",
     "Stage 2/Control value=0.01",
     "Stage 2/Load factor=1",
     "Stage 2/Load factors=supports: unchanged, edge forces alpha_2 max: 0.5"},
    "Stage 1/Load factors; b: Stage 2/Load factors[1]; Material strip/E",
    "load_factor, alpha_1 min F_x, middle u_z");
}
