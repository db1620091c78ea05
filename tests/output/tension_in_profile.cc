// SPDX-License-Identifier: LGPL-2.1-or-later

// In a stretched strip, profile-NNNN.csv and history.csv give the tension of
// fibers in each ply, modulus times strain and thickness, and nothing for
// plies without fibers; the middle of the carcass is that of the
// plies with fibers; on any number of ranks.

#include <deal.II/base/mpi.h>

#include <sstream>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ostringstream               out, err;
  Biface::run_program(
    {DATA_DIR "/strip_of_fibers.prm"}, MPI_COMM_WORLD, out, err);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  std::cout << err.str();

  // the strain is 0.001
  const double tension = 1000 * 0.001 * 0.2;
  double       error = 0, across = 0, height = 0;
  bool         empty = true;
  for (const Row &row : read_csv("results/profile-0001.csv"))
    {
      const auto number = [&](const std::string &name) {
        return std::stod(row.at(name));
      };
      for (const std::string ply : {"2", "4"})
        error =
          std::max(error, std::abs(number("fiber_tension_" + ply) - tension));
      across = std::max(across, std::abs(number("fiber_tension_3")));
      empty  = empty && row.at("fiber_tension_1").empty();
      // plies 2 to 4 reach from 0.1 to 0.6 above the inner face
      height = std::max(
        height, std::abs(number("carcass_z") - number("inner_z") - 0.35));
    }
  check_small("tension along the strip", error, 1e-9, tension);
  check_small("tension across", across, 1e-9, tension);
  check_true("none in plies without fibers", empty);
  check_small("height of the carcass", height, 1e-9);

  const Row history = read_csv("results/history.csv").back();
  check_small("maximum",
              std::stod(history.at("max_fiber_tension")) - tension,
              1e-9,
              tension);
  std::cout << "in ply " << history.at("max_fiber_tension_ply") << " at ("
            << history.at("max_fiber_tension_alpha_1") << ", "
            << history.at("max_fiber_tension_alpha_2") << ")" << std::endl;
}
