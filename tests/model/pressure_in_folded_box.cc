// SPDX-License-Identifier: LGPL-2.1-or-later

// The pressure in a box of irregular cells, with folds at its edges and three
// parts at its corners, is in balance however large the deformation: nothing is
// left for isostatic supports, and the iteration converges as with a symmetric
// tangent. The displacements do not depend on the number of ranks.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <map>
#include <sstream>

#include <biface/program/program.h>

#include <irregular_mesh.h>
#include <read_csv.h>
#include <tests.h>

using namespace dealii;

namespace
{
  constexpr unsigned int n = 4;

  /** Of one rank. */
  constexpr double expected_displacement = 0.00281460080202;


  /** The box of the unit cube, whose six sides are irregular. */
  void
  write_mesh()
  {
    const auto side = [](const unsigned int which) {
      return [which](const double u, const double v) {
        switch (which)
          {
            case 0:
              return Point<3>(v, u, 0);
            case 1:
              return Point<3>(u, v, 1);
            case 2:
              return Point<3>(u, 0, v);
            case 3:
              return Point<3>(v, 1, u);
            case 4:
              return Point<3>(0, v, u);
            default:
              return Point<3>(1, u, v);
          }
      };
    };
    std::vector<Point<3>>                       nodes;
    std::map<std::array<long, 3>, unsigned int> known;
    std::vector<std::string>                    cells;
    for (unsigned int s = 0; s < 6; ++s)
      {
        // nodes of edges stay where they are, so that sides meet
        const IrregularMesh regular = irregular_mesh(n, n, 0, side(s)),
                            moved   = irregular_mesh(n, n, 0.25, side(s));
        const auto number = [&](const unsigned int i, const unsigned int j) {
          const bool     inside = (i > 0 && i < n && j > 0 && j < n);
          const Point<3> x =
            (inside ? moved : regular).nodes[regular.node(i, j)];
          const auto entry =
            known.emplace(std::array<long, 3>{{std::lround(1e6 * x[0]),
                                               std::lround(1e6 * x[1]),
                                               std::lround(1e6 * x[2])}},
                          nodes.size());
          if (entry.second)
            nodes.push_back(x);
          return entry.first->second + 1;
        };
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            cells.push_back("3 0 " + std::to_string(number(i, j)) + ' ' +
                            std::to_string(number(i + 1, j)) + ' ' +
                            std::to_string(number(i + 1, j + 1)) + ' ' +
                            std::to_string(number(i, j + 1)));
      }
    std::ofstream("box.msh") << gmsh_text(nodes, cells, 17);
  }


  void
  write_parameters()
  {
    std::ofstream("box.prm")
      << "set Materials = rubber\n"
         "subsection Surface\n  set Type = mesh\n"
         "  subsection Mesh\n    set File = box.msh\n"
         "    set Direction = 1; 0.3; 0.2\n  end\nend\n"
         "subsection Material rubber\n  set E = 1\n  set nu = 0.3\nend\n"
         "subsection Laminate\n  set Plies = rubber: 0.1 @ 0\n"
         "  set Reference surface = middle\nend\n"
         "set Named points = O: 0 0 0, X: 1 0 0, Y: 0 1 0, M: 1 1 1\n"
         "subsection Supports\n  set Point supports = O: x middle, "
         "O: y middle, O: z middle, X: y middle, X: z middle, Y: z middle\nend\n"
         "subsection Stage 1\n  set Pressure = 0.01\n  set Steps = 1\nend\n";
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_first = (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  if (is_first)
    {
      write_mesh();
      write_parameters();
    }
  MPI_Barrier(MPI_COMM_WORLD);
  std::ostringstream out, err;
  Biface::run_program(
    {"--output", "results", "box.prm"}, MPI_COMM_WORLD, out, err);
  if (!is_first)
    return 0;
  std::cout << err.str();

  // the pressure on one of the sides is 0.01
  double largest = 0;
  for (const Row &row : read_csv("results/forces.csv"))
    for (const char *column : {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"})
      largest = std::max(largest, std::abs(std::stod(row.at(column))));
  check_small("resultants of supports and loads", largest, 1e-12, 0.01);
  const Row last = read_csv("results/history.csv").back();
  check_small("iterations", std::stod(last.at("iterations")), 6);
  for (const Row &row : read_csv("results/probes.csv"))
    if (row.at("name") == "M" && row.at("face") == "middle")
      check_small("displacement of a corner",
                  std::stod(row.at("u_z")) - expected_displacement,
                  1e-8,
                  expected_displacement);
}
