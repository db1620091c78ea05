// SPDX-License-Identifier: LGPL-2.1-or-later

// Plies that vary over a mesh from a file, on any number of ranks and in both
// distributions: an angle that is a formula of the position is the same as a
// direction that turns with it; and a tapered bar is pulled as the sections in
// the middle of its cells say.

#include <deal.II/base/mpi.h>

#include <fstream>

#include "../irregular_mesh.h"
#include "../run_analysis.h"
#include "../tests.h"
#include "displacement_of_point.h"

using namespace dealii;
using namespace Biface;

namespace
{
  const double       length = 10, width = 4;
  const unsigned int n = 5;


  Point<3>
  plate(const double u, const double v)
  {
    return Point<3>(length * u, width * v, 0);
  }


  void
  write_files()
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream("irregular.msh")
          << gmsh_text(irregular_mesh(n, 3, 0.25, plate));
        std::ofstream("regular.msh")
          << gmsh_text(irregular_mesh(n, 3, 0, plate));
        std::ofstream("plate.prm")
          << "set Materials = ply\n"
             "set Number of stages = 1\n"
             "subsection Surface\n  set Type = mesh\n"
             "  subsection Mesh\n    set File = irregular.msh\n  end\nend\n"
             "subsection Material ply\n  set Type = transversely isotropic\n"
             "  set E_L = 1000\n  set E_T = 100\n  set G_LT = 60\n"
             "  set nu_LT = 0.3\n  set nu_TT = 0.4\n  set G_TT = 40\nend\n"
             "subsection Laminate\n  set Plies = ply: 0.5 @ 0\n"
             "  set Reference surface = middle\nend\n"
             "subsection Supports\n  set Edge supports = west: fixed\nend\n"
             "subsection Loads\n"
             "  set Edge forces = east: 3 0.5 0.01\nend\n"
             "subsection Stage 1\n  set Load factor = 1\nend\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }


  /** The displacement of the middle at point C at the end of a run. */
  Tensor<1, 3>
  displacement(const std::vector<Override> &overrides)
  {
    return displacement_of_point("plate.prm", "C", overrides);
  }


  void
  angles()
  {
    const Tensor<1, 3> exact =
      displacement({"Surface/Mesh/Direction=cos(x*pi/18); sin(x*pi/18); 0"});
    for (const std::string distribution : {"shared", "distributed"})
      check_small("angle",
                  (displacement({"Laminate/Plies=ply: 0.5 @ 10*x",
                                 "Mesh/Distribution=" + distribution}) -
                   exact)
                    .norm(),
                  1e-10,
                  exact.norm());
  }


  void
  tapered_bar()
  {
    const double E = 200, force = 0.3;
    double       exact = 0;
    for (unsigned int i = 0; i < n; ++i)
      exact += force / E * (length / n) / (1 - 0.06 * (i + 0.5) * length / n);
    check_small("tapered bar",
                displacement({"Surface/Mesh/File=regular.msh",
                              "Material ply/Type=isotropic",
                              "Material ply/E=200",
                              "Material ply/nu=0",
                              "Laminate/Plies=ply: 0.25-0.015*x @ 0, "
                              "ply: 0.75-0.045*x @ 0",
                              "Supports/Edge supports=west: x both",
                              "Supports/Point supports=A: y both; z both, "
                              "D: z both, B: z both",
                              "Loads/Edge forces=east: 0.3 0 0",
                              "Stage 1/Strain theory=linear"})[0] -
                  exact,
                1e-10,
                exact);
  }
} // namespace


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // the first rank prints
  std::ostringstream    silence;
  std::streambuf *const screen = std::cout.rdbuf();
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.rdbuf(silence.rdbuf());
  write_files();
  angles();
  tapered_bar();
  std::cout.rdbuf(screen);
}
