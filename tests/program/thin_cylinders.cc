// SPDX-License-Identifier: LGPL-2.1-or-later

// The energy of cylinders under the pressure p cos(2 theta) converges with
// order 2, and equally fast from t/L = 1e-2 to 1e-5: with free ends, where the
// shell bends, and with fixed ends, where it carries the load as a membrane.

#include <cmath>

#include "../run_analysis.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  double
  energy(const std::string &thickness, const unsigned int n, const bool fixed)
  {
    // the same displacements for all thicknesses if the ends are free
    const double pressure =
      1e10 * std::pow(std::stod(thickness), fixed ? 1 : 3);
    return energy_at_end(
      DATA_DIR "/thin_cylinder.prm",
      {"Laminate/Plies=wall: " + thickness + " @ 0",
       "Mesh/Intervals alpha_1=0:1:" + std::to_string(n),
       "Mesh/Intervals alpha_2=0:90:" + std::to_string(n),
       std::string("Supports/alpha_1 max=") + (fixed ? "fixed" : "free"),
       "Stage 1/Pressure=" + std::to_string(pressure)});
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool fixed : {false, true})
    for (const std::string thickness : {"1e-2", "1e-3", "1e-4", "1e-5"})
      {
        // on finer meshes round-off of the thinnest shell reaches their error
        const double coarse = energy(thickness, 6, fixed),
                     medium = energy(thickness, 12, fixed),
                     fine   = energy(thickness, 24, fixed);
        std::cout << (fixed ? "fixed" : "free") << " ends, t/L = " << thickness
                  << std::endl;
        check_range(
          "  order", std::log2((medium - coarse) / (fine - medium)), 1.8, 2.7);
        check_range("  change from 6 to 12 cells",
                    std::abs(medium - coarse) / fine,
                    0.035,
                    0.075);
      }
}
