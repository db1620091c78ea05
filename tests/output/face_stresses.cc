// SPDX-License-Identifier: LGPL-2.1-or-later

// The stresses on the faces in profile-NNNN.csv are those of a clamped strip
// under an axial force and a moment at its end, F/h + 6 M/h^2 on one face and
// F/h - 6 M/h^2 on the other, and so is the equivalent stress, on any number of
// ranks.

#include <deal.II/base/mpi.h>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../restart.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr double                 force = 0.03, moment = 0.001;
  const Ended ended = run({DATA_DIR "/../verification/buckling_column.prm",
                           "--set",
                           "Stage 1/Strain theory=linear",
                           "--set",
                           "Stage 1/Buckling=0",
                           "--set",
                           "Stage 1/Load factor=1",
                           "--set",
                           "Loads/Edge forces=alpha_1 max: 0.03 0 0",
                           "--set",
                           "Loads/Edge moments=alpha_1 max: 0.001 dead"},
                          "results",
                          MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  std::cout << ended.code << ended.err << std::endl;

  double                 error = 0, sign = 0;
  const std::vector<Row> rows = read_csv("results/profile-0001.csv");
  std::cout << rows.size() << " nodes" << std::endl;
  for (const Row &row : rows)
    for (const std::string face : {"outer", "inner"})
      {
        const auto number = [&](const std::string &name) {
          return std::stod(row.at(face + "_" + name));
        };
        if (sign == 0)
          sign = (number("s_11") > force ? 1 : -1);
        const double stress =
          force + (face == "outer" ? 1 : -1) * sign * 6 * moment;
        for (const double value : {number("s_11") - stress,
                                   number("von_mises") - std::abs(stress),
                                   number("s_22"),
                                   number("s_12")})
          error = std::max(error, std::abs(value));
      }
  check_small("stresses", error, 1e-9, force);
}
