// SPDX-License-Identifier: LGPL-2.1-or-later

// An irregular plate under pressure on a rigid plane touches it at all nodes
// with this pressure, whatever the mass of the multipliers; points in cells, at
// which the forces are those of the midpoint rule, within 2 %.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include <biface/program/program.h>

#include <irregular_mesh.h>
#include <read_csv.h>
#include <tests.h>

using namespace dealii;

namespace
{
  void
  write_files()
  {
    std::ofstream("plate.msh")
      << gmsh_text(irregular_mesh(6, 5, 0.25, [](double u, double v) {
           return Point<3>(10 * u, 8 * v, 0);
         }));
    std::ofstream("plate.prm")
      << "set Materials = steel\n"
         "subsection Surface\n  set Type = mesh\n"
         "  subsection Mesh\n    set File = plate.msh\n  end\nend\n"
         "subsection Material steel\n  set E = 1000\nend\n"
         "subsection Laminate\n  set Plies = steel: 0.1 @ 0\nend\n"
         "subsection Supports\n"
         "  set Point supports = A: x middle; y middle, B: y middle\nend\n"
         "subsection Loads\n  set Pressure type = dead\nend\n"
         "subsection Contact\n  set Direction = 0, 0, 1\n"
         "  set Regularization = 1e3\nend\n"
         "subsection Stage 1\n  set Contact = true\n  set Travel = 1e-6\n"
         "  set Pressure = 0.01\nend\n";
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (is_root)
    write_files();
  MPI_Barrier(MPI_COMM_WORLD);

  for (const std::string setting : {"Multiplier mass=lumped",
                                    "Multiplier mass=consistent",
                                    "Points in cells=3"})
    {
      std::ostringstream out, err;
      Biface::run_program(
        {"--output", "results", "--set", "Contact/" + setting, "plate.prm"},
        MPI_COMM_WORLD,
        out,
        err);
      if (!is_root)
        continue;
      double     deviation = 0;
      const auto rows      = read_csv("results/contact-0001.csv");
      for (const Row &row : rows)
        deviation =
          std::max(deviation, std::abs(std::stod(row.at("pressure")) - 0.01));
      std::cout << setting << std::endl;
      check_true("all nodes", rows.size() == 42);
      check_small("pressure", deviation, setting[0] == 'P' ? 0.02 : 1e-6, 0.01);
    }
}
