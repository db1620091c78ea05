// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces on a tire in contact are in balance; that of the ground is the
// force of the history; and the part of the balance that comes from the
// interpolation of rigid motions is small, of second order in the size of the
// cells.

#include <biface/stepping/step_report.h>

#include "forces.h"

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  std::vector<double> interpolation;
  for (const auto &mesh : std::vector<std::array<std::string, 2>>{
         {{"-120:120:14", "-180:180:24"}}, {{"-120:120:28", "-180:180:48"}}})
    {
      const Forces forces(PRM_DIR "/bias_tire.prm",
                          {"Mesh/Intervals alpha_1=" + mesh[0],
                           "Mesh/Intervals alpha_2=" + mesh[1],
                           "Loads/Pressure type=follower",
                           "Stage 2/Travel=16",
                           "Stage 2/Steps=4",
                           "Newton/Residual tolerance=1e-11"});
      if (!is_root)
        continue;
      const double force = forces.report.contact.force;
      check_true("in contact", force > 100);
      check_small("balance", forces.imbalance, 1e-8);
      check_small("force of the ground",
                  forces.of.at("foundation")[0] + force,
                  1e-9,
                  force);
      double rest = 0;
      for (unsigned int i = 0; i < 3; ++i)
        rest = std::max(rest, std::abs(forces.of.at("interpolation")[i]));
      interpolation.push_back(rest / force);
    }
  if (is_root)
    {
      check_small("interpolation", interpolation[1], 0.05);
      check_range("its decrease from mesh to mesh",
                  interpolation[0] / interpolation[1],
                  3,
                  6);
    }
}
