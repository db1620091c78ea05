// SPDX-License-Identifier: LGPL-2.1-or-later

// The footprint on an irregular mesh from a file, as nodes or points in cells
// measure it: a sphere that sinks into a stiff plate through a soft contact
// cuts a circle off it, of the radius a = sqrt(2 R d - d^2). On a flat mesh
// nothing warns of cells that turn, whatever the direction of plies.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <fstream>
#include <sstream>

#include <biface/program/program.h>

#include <irregular_mesh.h>
#include <read_csv.h>
#include <tests.h>

using namespace dealii;

namespace
{
  constexpr double R = 20, d = 0.3;


  void
  write_files()
  {
    std::ofstream("plate.msh")
      << gmsh_text(irregular_mesh(20, 16, 0.2, [](double u, double v) {
           return Point<3>(10 * u - 5, 8 * v - 4, 0);
         }));
    std::ofstream("plate.prm")
      << "set Materials = steel\n"
         "subsection Surface\n  set Type = mesh\n"
         "  subsection Mesh\n    set File = plate.msh\n"
         "    set Direction = -y; x; 0\n  end\nend\n"
         "subsection Material steel\n  set E = 1e6\nend\n"
         "subsection Laminate\n  set Plies = steel: 1 @ 0\nend\n"
         "subsection Supports\n  set Edge supports = south: fixed, east: fixed, "
         "north: fixed, west: fixed\nend\n"
         "subsection Contact\n  set Foundation = sphere\n"
         "  set Direction = 0, 0, 1\n  set Point on path = 0, 0, 0\n"
         "  subsection Sphere\n    set Radius = "
      << R
      << "\n  end\nend\n"
         "subsection Stage 1\n  set Contact = true\n  set Travel = "
      << d << "\nend\n";
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  write_files();

  const double radius = std::sqrt(2 * R * d - d * d);
  for (const std::string points : {"0", "3"})
    {
      std::ostringstream out, err;
      Biface::run_program({"--output",
                           "results",
                           "--set",
                           "Contact/Regularization=1e-3",
                           "--set",
                           "Contact/Points in cells=" + points,
                           "plate.prm"},
                          MPI_COMM_WORLD,
                          out,
                          err);
      std::cout << points << " points along the side of a cell" << std::endl;
      const Row  last = read_csv("results/history.csv").back();
      const auto of   = [&](const char *column) {
        return std::stod(last.at(column));
      };
      // to a third of a cell, in which the edge jumps
      const double tolerance = (points == "0" ? 0.25 : 0.08);
      check_small("area",
                  of("footprint_area") - numbers::PI * radius * radius,
                  tolerance,
                  2 * numbers::PI * radius);
      check_small(
        "length", of("footprint_length") - 2 * radius, 3 * tolerance, 1);
      check_small(
        "width", of("footprint_width") - 2 * radius, 3 * tolerance, 1);
      check_true("no cells that turn",
                 (out.str() + err.str()).find("cells turn") ==
                   std::string::npos);
    }
}
