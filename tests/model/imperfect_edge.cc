// SPDX-License-Identifier: LGPL-2.1-or-later

// Where a support holds a face along the normal, the stress-free shell has no
// imperfection, and its wall is as thick as elsewhere; a support that holds a
// face along the surface leaves the imperfection.

#include <algorithm>
#include <cmath>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/shell_mesh.h>

#include <run_analysis.h>
#include <tests.h>

using namespace Biface;

namespace
{
  /** The displacements of both faces at the edge alpha_1 max and of its
   * neighbors, and the change of the thickness anywhere. */
  struct Shape
  {
    double at_edge = 0, inside = 0, thickness = 0;
  };

  Shape
  shape(const std::string &support)
  {
    Shape result;
    run_analysis(DATA_DIR "/imperfect_column.prm",
                 {{"Surface/Imperfection/Formula=0.5", "test"},
                  {"Supports/alpha_1 max=" + support, "test"},
                  {"Number of stages=1", "test"}},
                 [&](const ShellEquations &equations,
                     const StepReport & /*report*/,
                     const State &state) {
                   for (const Node &node : equations.mesh.nodes)
                     {
                       const double inner = equations.mesh.displacement(
                         state.displacement, node, Resultants::inner)[2];
                       const double outer = equations.mesh.displacement(
                         state.displacement, node, Resultants::outer)[2];
                       double &w = (node.alpha[0] > 199.9 ? result.at_edge
                                                          : result.inside);
                       w         = std::max(w, std::abs(outer));
                       result.thickness =
                         std::max(result.thickness, std::abs(outer - inner));
                     }
                 });
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const char *support : {"z middle", "z inner", "z outer", "fixed"})
    {
      const Shape held = shape(support);
      check_small(std::string(support) + ", edge", held.at_edge, 1e-14);
      check_small("  inside", held.inside - 0.5, 1e-14);
      check_small("  thickness", held.thickness, 1e-14);
    }
  const Shape free = shape("x inner");
  check_small("x inner, edge", free.at_edge - 0.5, 1e-14);
  check_small("  thickness", free.thickness, 1e-14);
}
