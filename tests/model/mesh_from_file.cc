// SPDX-License-Identifier: LGPL-2.1-or-later

// On an irregular mesh from a file, on any number of ranks and in both
// distributions: a plate of oblique fibers under tension has exactly the
// strains of its compliance, whatever the direction from which the angle
// counts; moments along edges bend it to an exact cylinder; a dead traction and
// an area force are those of the area; and supports by groups and by points
// hold.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <fstream>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/stepping/step_report.h>

#include "../irregular_mesh.h"
#include "../run_analysis.h"
#include "../tests.h"
#include "displacement_of_point.h"

using namespace dealii;
using namespace Biface;

namespace
{
  const double length = 10, width = 8, thickness = 0.5;


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
        std::ofstream("plate.msh")
          << gmsh_text(irregular_mesh(5, 4, 0.25, plate));
        std::ofstream("plate.prm")
          << "set Materials = ply\n"
             "set Number of stages = 1\n"
             "subsection Surface\n  set Type = mesh\n"
             "  subsection Mesh\n    set File = plate.msh\n  end\nend\n"
             "subsection Material ply\n  set Type = transversely isotropic\n"
             "  set E_L = 1000\n  set E_T = 100\n  set G_LT = 60\n"
             "  set nu_LT = 0.3\n  set nu_TT = 0.4\n  set G_TT = 40\nend\n"
             "subsection Laminate\n  set Plies = ply: 0.5 @ 30\n"
             "  set Reference surface = middle\nend\n"
             "subsection Supports\n"
             "  set Point supports = A: x middle; y middle; z middle, "
             "B: y middle; z middle, D: z middle\nend\n"
             "subsection Stage 1\n  set Strain theory = linear\n"
             "  set Load factor = 1\nend\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }


  /** The displacement of the middle at a named point at the end of a run. */
  Tensor<1, 3>
  displacement(const std::string &point, const std::vector<Override> &overrides)
  {
    return displacement_of_point("plate.prm", point, overrides);
  }


  void
  tension()
  {
    const double c = std::cos(numbers::PI / 6), s = std::sin(numbers::PI / 6);
    const double E_L = 1000, E_T = 100, G = 60, nu = 0.3, sigma = 3 / thickness;
    // strains of a stress along x of fibers at 30 degrees
    const double e_xx  = sigma * (c * c * c * c / E_L + s * s * s * s / E_T +
                                 c * c * s * s * (1 / G - 2 * nu / E_L));
    const double e_yy  = sigma * (c * c * s * s * (1 / E_L + 1 / E_T - 1 / G) -
                                 nu / E_L * (c * c * c * c + s * s * s * s));
    const double gamma = sigma * c * s *
                         (2 * c * c / E_L - 2 * s * s / E_T +
                          2 * nu / E_L * (c * c - s * s) - (c * c - s * s) / G);
    // without turning of the line from A to B
    const Tensor<1, 3> exact({e_xx * length + gamma * width, e_yy * width, 0.});

    const std::vector<std::string> pull{
      "Loads/Edge forces=east: 3 0 0, west: -3 0 0"};
    const std::vector<std::vector<Override>> directions{
      {},
      {"Surface/Mesh/Direction=cos(pi/9); sin(pi/9); 7",
       "Laminate/Plies=ply: 0.5 @ 10"},
      {"Surface/Mesh/Direction=0; -1; 0", "Laminate/Plies=ply: 0.5 @ 120"},
      {"Mesh/Distribution=distributed"}};
    for (std::vector<Override> overrides : directions)
      {
        overrides.emplace_back(pull[0]);
        check_small("tension",
                    (displacement("C", overrides) - exact).norm(),
                    1e-11,
                    exact.norm());
      }
  }


  void
  bending()
  {
    // a moment that bends the outer face into tension at both ends, of a plate
    // without Poisson's ratio
    const double E = 200, M = 0.04;
    const double curvature = 12 * M / (E * thickness * thickness * thickness);
    const std::vector<Override> of_plate{
      "Material ply/Type=isotropic",
      "Material ply/E=200",
      "Material ply/nu=0",
      "Loads/Edge moments=east: 0.04 dead, west: 0.04 dead"};
    // A, B and D hold the chord: the others are lower or higher by the arc
    std::vector<Override> overrides = of_plate;
    overrides.emplace_back(
      "Supports/Point supports=A: x middle; y middle; z middle, D: x middle; z "
      "middle");
    overrides.emplace_back("Supports/Edge supports=west: x both");
    const Tensor<1, 3> u = displacement("C", overrides);
    check_small("bending",
                std::abs(u[2]) - curvature * length * length / 2,
                1e-11,
                curvature * length * length / 2);
  }


  void
  loads()
  {
    for (const std::string load : {"Loads/Outer traction=0.1; 0.2; 0.3",
                                   "Loads/Area force=0.1, 0.2, 0.3"})
      {
        Tensor<1, 3> force, moment;
        run_analysis(
          "plate.prm",
          {load,
           "Supports/Point supports=",
           "Supports/Edge supports=west: fixed"},
          [&](const ShellEquations &, const StepReport &report, const State &) {
            for (const ForceOnShell &item : report.forces_of_bodies)
              if (item.body == "west")
                {
                  force  = item.force;
                  moment = item.moment;
                }
          });
        const Tensor<1, 3> exact =
          -length * width * Tensor<1, 3>({0.1, 0.2, 0.3});
        check_small("force", (force - exact).norm(), 1e-11, exact.norm());
        // about the origin; half the thickness is no lever of forces in the
        // plane for the area force alone
        const double by_z = exact[2] * width / 2;
        check_small("moment",
                    moment[0] - by_z +
                      (load.find("Outer") != std::string::npos
                         ? exact[1] * thickness / 2
                         : 0.),
                    1e-11,
                    std::abs(by_z));
      }
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
  tension();
  bending();
  loads();
  std::cout.rdbuf(screen);
}
