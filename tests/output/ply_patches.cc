// SPDX-License-Identifier: LGPL-2.1-or-later

// The plies are written as one hexahedron of positive volume per ply and cell;
// together they have the volume of the shell, with second order in the cell
// size.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include <biface/model/equations/shell_equations.h>
#include <biface/output/plies_vtu.h>

#include "../model/cord_shells.h"
#include "../tests.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** The volume of a hexahedron, in VTK's order: both quadrilaterals one after
   * the other, each around. */
  double
  volume(const std::array<Point<3>, 8> &x)
  {
    const QGauss<3> quadrature(2);
    double          sum = 0;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<3> &xi = quadrature.point(q);
        Tensor<2, 3>    J;
        for (unsigned int v = 0; v < 8; ++v)
          {
            const bool at[3] = {v % 4 == 1 || v % 4 == 2, v % 4 >= 2, v >= 4};
            for (unsigned int a = 0; a < 3; ++a)
              {
                double slope = 1;
                for (unsigned int b = 0; b < 3; ++b)
                  slope *=
                    (a == b ? (at[b] ? 1 : -1) : (at[b] ? xi[b] : 1 - xi[b]));
                for (unsigned int i = 0; i < 3; ++i)
                  J[i][a] += slope * x[v][i];
              }
          }
        sum += quadrature.weight(q) * determinant(J);
      }
    return sum;
  }


  struct Hexahedra
  {
    unsigned int n        = 0;
    double       volume   = 0;
    double       smallest = std::numeric_limits<double>::max();
  };


  Hexahedra
  hexahedra(const ShellMesh &mesh)
  {
    const ShellEquations equations(mesh);
    PlyPatches           patches(equations, State(mesh), FailureCriteria());
    std::stringstream    stream;
    stream.precision(12);
    patches.write_vtk(stream);

    Hexahedra             result;
    std::vector<Point<3>> points;
    std::string           word;
    while (stream >> word)
      if (word == "POINTS")
        {
          unsigned int n;
          stream >> n >> word;
          points.resize(n);
          for (Point<3> &x : points)
            stream >> x[0] >> x[1] >> x[2];
        }
      else if (word == "CELLS")
        {
          unsigned int n_numbers;
          stream >> result.n >> n_numbers;
          for (unsigned int c = 0; c < result.n; ++c)
            {
              unsigned int n, v;
              stream >> n;
              AssertThrow(n == 8, ExcDimensionMismatch(n, 8));
              std::array<Point<3>, 8> x;
              for (Point<3> &vertex : x)
                {
                  stream >> v;
                  vertex = points[v];
                }
              const double part = volume(x);
              result.volume += part;
              result.smallest = std::min(result.smallest, part);
            }
        }
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // volume between the arcs of radii R - 0.5 and R + 1 about the circle of
  // radius 200: the turn times the integral of (200 + r cos psi) r dr dpsi
  const std::string plies = "cord: 0.2 @ 52, cord: 1 @ -52, cord: 0.3 @ 0";
  const double      a = 49.5, b = 51;
  const double      begin = -numbers::PI / 6, end = numbers::PI / 2;
  const double      exact =
    2 * numbers::PI *
    (200 * (b * b - a * a) / 2 * (end - begin) +
     (b * b * b - a * a * a) / 3 * (std::sin(end) - std::sin(begin)));

  const auto coarse_shell = torus(10, 24, plies);
  const auto fine_shell   = torus(20, 48, plies);
  const auto coarse = hexahedra(*coarse_shell), fine = hexahedra(*fine_shell);
  check_true("one hexahedron for each ply of each cell",
             coarse.n == 3 * coarse_shell->n_cells() &&
               fine.n == 3 * fine_shell->n_cells());
  check_true("positive volumes", coarse.smallest > 0 && fine.smallest > 0);
  check_small("volume", fine.volume - exact, 5e-3, exact);
  check_range("order, as the ratio of deviations",
              (coarse.volume - exact) / (fine.volume - exact),
              3.8,
              4.2);

  // -30:90:10 has the lines 6 and 54: four cells of the ten
  const auto part = torus(10, 24, "cord: 0.5 @ 0, cord: 1 @ 30 from 6 to 54");
  check_true("a ply only where it is", hexahedra(*part).n == (10 + 4) * 24);
}
