// SPDX-License-Identifier: LGPL-2.1-or-later

// Under true pressure the equator of the bias tire moves inward on inflation,
// by 1.266 mm in the limit of fine meshes, less than the 1.79 mm under the dead
// pressure of the paper. The error is of second order in the size of the cells
// along the meridian.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <sstream>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

namespace
{
  /** How far the outer face moves outward at the equator on inflation.
   * @param n the number of parts of each cell of the given mesh along the
   * meridian; there are few around the axle, which make no difference. */
  double
  outward_displacement(const std::string &file, const unsigned int n)
  {
    const auto cells = [n](const unsigned int given) {
      return std::to_string(n * given);
    };
    const std::vector<std::string> arguments{
      "--output",
      "results",
      "--set",
      "Mesh/Intervals alpha_1=-120:-45:" + cells(12) + ", -45:45:" + cells(18) +
        ", 45:120:" + cells(12),
      "--set",
      "Mesh/Intervals alpha_2=-180:180:8",
      "--set",
      "Stage 2/Contact=false",
      "--set",
      "Stage 2/Travel=0",
      "--set",
      "Stage 2/Steps=1",
      PRM_DIR "/" + file};
    std::ostringstream out;
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
    "dead pressure", outward_displacement("bias_tire.prm", 1), -1.788, -1.784);

  const std::string file   = "bias_tire_true_pressure.prm";
  const double      coarse = outward_displacement(file, 2),
               fine        = outward_displacement(file, 4);
  check_small("true pressure, limit of fine meshes",
              fine + (fine - coarse) / 3 + 1.266,
              2e-4);
  check_range("error of the coarse mesh, over that of the fine one",
              (coarse + 1.266) / (fine + 1.266),
              3.5,
              4.5);
}
