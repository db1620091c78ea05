// SPDX-License-Identifier: LGPL-2.1-or-later

// In a stretched strip whose plies become thinner along it and have Poisson's
// ratio 0, history.csv and the table at the end give the failure index of the
// weakest ply in the thinnest cells, the first of these, and the ply, also far
// from the named points; on any number of ranks. Plies without strengths have
// none.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <sstream>

#include <biface/program/program.h>

#include "../read_csv.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  const char *const strip = R"(
subsection Surface
  set Type = plane
end
subsection Mesh
  set Intervals alpha_1  = 0:10:4
  set Intervals alpha_2  = 0:3:3
  set Closed in alpha_2  = false
end
set Materials = fiber, bare
subsection Material fiber
  set Type = orthotropic
  set E_1  = 1000
  set E_2  = 100
  set E_3  = 100
  set G_12 = 50
  set G_13 = 50
  set G_23 = 50
  set X_t  = 40
  set X_c  = 10
  set Y_t  = 3
  set Y_c  = 8
  set S    = 3
end
subsection Material bare
  set Type = isotropic
  set E    = 1e4
end
subsection Laminate
  set Plies             = fiber: 0.2 - 0.01*alpha_1 @ 0, bare: 0.1 @ 0, \
                          fiber: 0.1 @ 90, bare: 0.1 @ 0, \
                          fiber: 0.2 - 0.01*alpha_1 @ 0
  set Reference surface = middle
end
set Named points = begin: 0 0
subsection Supports
  set alpha_1 min = v_1 both; v_2 both; v_3 both
  set alpha_1 max = v_3 both
end
subsection Loads
  set Edge forces = alpha_1 max: 100 0 0
end
subsection Stage 1
  set Strain theory = linear
  set Load factor   = 1
  set Steps         = 2
end
subsection Output
  set Directory        = results
  set Failure criteria = maximum stress, Tsai-Wu
  set Write VTU        = false
end
)";
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  if (is_root)
    std::ofstream("strip.prm") << strip;
  MPI_Barrier(MPI_COMM_WORLD);
  char                program[] = "biface", file[] = "strip.prm";
  std::vector<char *> arguments{program, file, nullptr};
  std::stringstream   out;
  std::ostringstream  err;
  Biface::run_program(2, arguments.data(), MPI_COMM_WORLD, out, err);
  if (!is_root)
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
