// SPDX-License-Identifier: LGPL-2.1-or-later

// In a stretched strip whose plies become thinner along it and have Poisson's
// ratio 0, history.csv and the table at the end give the failure index of the
// weakest ply in the thinnest cells, the first of these, and the ply, also far
// from the named points; on any number of ranks. Plies without strengths have
// none.

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
  std::stringstream                out;
  std::ostringstream               err;
  Biface::run_program(
    {DATA_DIR "/thinning_strip.prm"}, MPI_COMM_WORLD, out, err);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  std::cout << err.str();

  // the force over the stiffness in the middle of the last cells, times the
  // modulus across the fibers, over the strength
  const double stiffness =
    2 * 1000 * (0.2 - 0.01 * 8.75) + 2 * 1e4 * 0.1 + 100 * 0.1;
  const double index = 100 / stiffness * 100 / 3;

  unsigned int n = 0;
  for (const Row &row : read_csv("results/history.csv"))
    {
      const double factor = ++n / 2.;
      std::cout << "step " << n << std::endl;
      for (const std::string name : {"maximum_stress", "tsai_wu"})
        {
          std::cout << "  " << name << " at (" << row.at(name + "_alpha_1")
                    << ", " << row.at(name + "_alpha_2") << "), ply "
                    << row.at(name + "_ply") << std::endl;
          check_small("  index",
                      std::stod(row.at(name + "_index")) - factor * index,
                      1e-9,
                      index);
        }
    }

  unsigned int n_in_table = 0;
  std::string  line;
  while (std::getline(out, line))
    for (std::size_t at = line.find(" at (7.5, 0), ply 3");
         at != std::string::npos;
         at = line.find(" at (7.5, 0), ply 3", at + 1))
      ++n_in_table;
  std::cout << "in the table: " << n_in_table << std::endl;
}
