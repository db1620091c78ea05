// SPDX-License-Identifier: LGPL-2.1-or-later

// The outputs of a study are any results by their names, at the end of the run
// or of a stage, or its extremes over the steps: the shortening F L/(E h) of a
// column, the force at its clamped end, its frequency
// 1.8751^2/(2 pi L^2) sqrt(E h^2/(12 rho)) and its critical load
// (2 k - 1)^2 pi^2 E h^3/(48 L^2).

#include <cmath>

#include "../read_csv.h"
#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  if (is_root)
    std::ofstream("column.prm")
      << "subsection Study\n"
         "set Base file = " PRM_DIR
         "/../tests/verification/buckling_column.prm\n"
         "set Settings = Material strip/Density=1e-9; Number of stages=2; "
         "Named points=tip: 100 10; Stage 1/Modes=1; Stage 1/Load factor=1e-3; "
         "Stage 1/Strain theory=linear; Stage 2/Load factor=0\n"
         "set Variables = E: Material strip/E\n"
         "set Values = E: 1e5, 2e5\n"
         "set Outputs = tip u_x @ push, alpha_1 min F_x @ push, "
         "frequency 1 @ push, buckling factor 2 @ push, tip u_x, "
         "minimum tip u_x, maximum tip u_x @ push, maximum load_factor\n"
         "end\n";
  MPI_Barrier(MPI_COMM_WORLD);
  const Ended ended = run({"--study", "column.prm"}, "column", MPI_COMM_WORLD);
  if (!is_root)
    return 0;

  std::cout << ended.code << ended.err << std::endl;
  for (const Row &row : read_csv("column/study.csv"))
    {
      const double pi = numbers::PI, L = 100, E = std::stod(row.at("E"));
      const auto   check = [&](const std::string &name, const double value) {
        check_small(
          name, std::stod(row.at(name + " @ push")) / value - 1, 2e-3);
      };
      check("tip u_x", -1e-3 * L / E);
      check("alpha_1 min F_x", 1e-2);
      check("frequency 1",
            std::pow(1.875104 / L, 2) / (2 * pi) * std::sqrt(E / 12e-9));
      check("buckling factor 2", 1e3 * 9 * pi * pi * E / (48 * L * L));
      check_small("tip u_x at the end", std::stod(row.at("tip u_x")), 1e-10);
      // one step pushes, and one releases
      for (const std::string extreme :
           {"minimum tip u_x", "maximum tip u_x @ push"})
        check_small(extreme,
                    std::stod(row.at(extreme)) -
                      std::stod(row.at("tip u_x @ push")),
                    1e-15);
      check_small("maximum load factor",
                  std::stod(row.at("maximum load_factor")) - 1e-3,
                  1e-15);
    }
}
