// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the error of the interpolation of rigid motions exceeds 1 % of the
// largest reaction, a stage has one warning with the force in forces.csv; a
// flat shell has none.

#include <deal.II/base/mpi.h>

#include <sstream>
#include <string>
#include <vector>

#include <biface/program/program.h>

#include <read_csv.h>
#include <tests.h>

using namespace dealii;

namespace
{
  const std::string what = "error of the interpolation of rigid motions, ";

  /** What the program prints. */
  std::string
  printed(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), {"--output", "results"});
    std::ostringstream out, err;
    Biface::run_program(arguments, MPI_COMM_WORLD, out, err);
    return out.str() + err.str();
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // long cells around the axle, opposite the ground
  const std::string text = printed(
    {"--set",
     "Mesh/Intervals alpha_1=-120:120:14",
     "--set",
     "Mesh/Intervals alpha_2=-180:-20:4:smooth,-20:20:6,20:180:4:smooth",
     "--set",
     "Stage 2/Steps=2",
     PRM_DIR "/bias_tire.prm"});
  double                   force = 0, largest = 0;
  std::vector<std::string> warnings;
  for (const Row &row : read_csv("results/forces.csv"))
    if (row.at("step") == "1")
      {
        const double size = std::hypot(std::stod(row.at("F_x")),
                                       std::stod(row.at("F_y")),
                                       std::stod(row.at("F_z")));
        if (row.at("body") == "interpolation")
          force = size;
        else if (row.at("body").rfind("alpha_1", 0) == 0)
          largest = std::max(largest, size);
      }
  for (auto at = text.find(what); at != std::string::npos;
       at      = text.find(what, at + 1))
    warnings.push_back(text.substr(at + what.size(), 100));
  std::cout << warnings.size() << " warnings in two stages" << std::endl;
  check_small("force", std::stod(warnings.at(0)) - force, 1e-3, force);
  check_small("part of the largest reaction",
              std::stod(warnings[0].substr(warnings[0].find(" or ") + 4)) -
                100 * force / largest,
              0.05,
              100 * force / largest);

  check_true("none in a flat strip",
             printed({DATA_DIR "/sagging_strip.prm"}).find(what) ==
               std::string::npos);
}
