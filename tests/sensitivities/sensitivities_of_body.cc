// SPDX-License-Identifier: LGPL-2.1-or-later

// Where a force finds the turn of a body, derivatives by the force, by the
// place of the body, by the spring and by the thickness of the shell are those
// of whole runs, and nothing depends on the unit of the motion, without and
// with friction, at nodes and points in cells. So are those where a force finds
// the displacement of supports.

#include <biface/problem/parameters.h>

#include "sensitivities.h"
#include <tests.h>

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string           file = DATA_DIR "/plate_and_bodies.prm";
  const std::vector<Override> lifted{"Supports/alpha_1 min=fixed",
                                     "Stage 1/Bodies=lever",
                                     "Stage 1/Forces on bodies=lever lift: -10",
                                     "Body lever/Springs=lift: 3"};
  for (const std::string friction : {"0", "0.2"})
    {
      std::vector<Override> all = lifted;
      all.emplace_back("Body lever/Friction=" + friction);
      all.emplace_back("Stage 1/Steps=2");
      check_sensitivities("friction " + friction,
                          file,
                          all,
                          "Laminate/Plies[1]; Body lever/Springs[1]; Material "
                          "rubber/E; Stage 1/Forces on bodies[1]",
                          "strain_energy, lever_turn_y, lever F_z");
    }
  std::vector<Override> in_cells = lifted;
  in_cells.emplace_back("Contact/Points in cells=2");
  in_cells.emplace_back("Body lever/Friction=0.2");
  in_cells.emplace_back("Stage 1/Steps=2");
  // so low that it does not touch the edge that is held
  in_cells.emplace_back("Body lever/Point=0, 5, -1.01");
  check_sensitivities("points in cells",
                      file,
                      in_cells,
                      "Laminate/Plies[1]; Stage 1/Forces on bodies[1]",
                      "strain_energy, lever_turn_y, lever F_z");
  check_sensitivities("place of the body",
                      file,
                      lifted,
                      "Body lever/Point[3]",
                      "strain_energy, lever_turn_y, lever F_z");

  check_sensitivities(
    "supports",
    DATA_DIR "/strip_with_mass.prm",
    {"Stage 1/Forces on bodies=supports: 100"},
    "Laminate/Plies[1]; Stage 1/Forces on bodies[1]; "
    "Supports/Springs[1]; Supports/alpha_1 max[1]",
    "strain_energy, alpha_1_max_displacement, alpha_1 min F_x");

  const SensitivityTable table =
    table_of(file,
             {lifted[0],
              lifted[1],
              lifted[2],
              "Sensitivities/Entries=Body lever/Motions[4]",
              "Sensitivities/Outputs=strain_energy, lever_turn_y"});
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    for (unsigned int o = 0; o < 2; ++o)
      check_small(table.outputs[o].name + " by the unit of the motion",
                  table.logarithmic(0, o),
                  1e-8);
}
