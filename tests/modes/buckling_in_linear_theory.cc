// SPDX-License-Identifier: LGPL-2.1-or-later

// In linear strain theory, buckling loads are the classical ones, whatever part
// or multiple of them is applied in whatever steps: of Euler's column,
// pi^2 E I/(4 L^2), of a cylinder under axial compression, 0.605 E h/R, and
// under pressure that follows its wall, 3 E I/R^3.

#include <cmath>

#include <biface/stepping/buckling.h>

#include "../run_analysis.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  LoadLevel
  critical(const std::string &file, const std::string &load, const int steps)
  {
    return run_analysis(PRM_DIR "/../tests/verification/" + file,
                        {"Stage 1/Strain theory=linear",
                         "Stage 1/Buckling=1",
                         "Stage 1/" + load,
                         "Stage 1/Steps=" + std::to_string(steps)})
      .back()
      .buckling->loads.at(0)
      .level;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  constexpr double pi = numbers::PI, E = 1e5, nu = 0.3;

  const double column =
    critical("buckling_column.prm", "Load factor=1", 1).factors[0];
  check_small("column", column / (pi * pi * E / 48e4) - 1, 5e-4);
  check_small("applied fifteen times",
              critical("buckling_column.prm", "Load factor=30", 3).factors[0] /
                  column -
                1,
              1e-8);

  const double shortening = 109.30102 / (1000 * std::sqrt(3 * (1 - nu * nu)));
  check_small("cylinder",
              critical("buckling_cylinder.prm", "Load factor=1", 1).factors[0] /
                  shortening -
                1,
              5e-3);

  const double pressure = -3 * E / (12e6 * (1 - nu * nu));
  check_small(
    "ring",
    critical("buckling_ring.prm", "Pressure=-0.1", 2).pressure / pressure - 1,
    2e-3);
}
