// SPDX-License-Identifier: LGPL-2.1-or-later

// Under true pressure the equator of the bias tire moves inward on inflation,
// by 1.26 mm, less than the 1.79 mm under the dead pressure of the paper.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <sstream>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

namespace
{
  /** How far the outer face moves outward at the equator on inflation. */
  double
  outward_displacement(const std::string &file)
  {
    const std::vector<std::string> arguments{"--output",
                                             "results",
                                             "--set",
                                             "Stage 2/Contact=false",
                                             "--set",
                                             "Stage 2/Travel=0",
                                             "--set",
                                             "Stage 2/Steps=1",
                                             PRM_DIR "/" + file};
    std::ostringstream             out;
    check_true(file + " runs",
               Biface::run_program(arguments, MPI_COMM_WORLD, out, std::cout) ==
                 0);

    for (const auto &node : read_csv("results/profile-0001.csv"))
      if (std::abs(std::stod(node.at("alpha_1"))) < 1e-6)
        return std::stod(node.at("outer_x")) - 254.8;
    return 0;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_range(
    "dead pressure", outward_displacement("bias_tire.prm"), -1.788, -1.784);
  check_range("true pressure",
              outward_displacement("bias_tire_true_pressure.prm"),
              -1.260,
              -1.252);
}
