// SPDX-License-Identifier: LGPL-2.1-or-later

// A state can be evaluated anywhere, on every rank: bilinear between the grid
// lines, also across the seam of a closed grid, and exact at the nodes.

#include <biface/model/state/grid_state.h>

#include "../bias_tire/bias_tire.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** A function that is bilinear in each cell: a hat around the seam of the
   * turn, where alpha_2 is ±pi, times one that is linear in alpha_1. */
  double
  hat(const Point<2> &alpha)
  {
    const double from_seam =
      numbers::PI - std::abs(std::remainder(alpha[1], 2 * numbers::PI));
    return (1 + alpha[0]) * std::max(0., 1 - from_seam / (numbers::PI / 4));
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Analysis analysis(
    PRM_DIR "/bias_tire.prm",
    {"Mesh/Intervals alpha_1=-120:120:6", "Mesh/Intervals alpha_2=-180:180:8"});
  const ShellMesh &mesh = analysis.simulation.get_equations().mesh;

  State      state(mesh);
  LA::Vector V = mesh.owned_vector();
  for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
    {
      const Node &node            = mesh.nodes[n];
      state.contacts[0].active[n] = std::abs(hat(node.alpha)) > 0.5;
      if (node.locally_owned)
        for (unsigned int i = 0; i < 6; ++i)
          V(node.dofs[i]) = (i + 1) * hat(node.alpha);
    }
  V.compress(VectorOperation::insert);
  state.displacement = V;
  // a resultant that is linear over each cell: its center's alpha_1, and the
  // second strain's slope in xi_2
  for (unsigned int c = 0; c < mesh.cells.size(); ++c)
    {
      state.resultants[c][0] = mesh.nodes[mesh.cells[c].nodes[0]].alpha[0];
      state.resultants[c][Modes::mode_of[1][1]] = 8;
    }

  const GridState grid_state(mesh, state);
  double          displacement_error = 0, largest = 0;
  for (const double alpha_1 : {-2.0, -1.7, 0., 0.3, 1.9})
    for (const double alpha_2 : {-3.14, -3.0, -2.6, -1., 0., 1.3, 2.5, 3.1})
      for (unsigned int i = 0; i < 6; ++i)
        {
          const Point<2> alpha(alpha_1, alpha_2);
          // component by component, mean and half difference
          const double expected = (i + 1) * hat(alpha);
          largest               = std::max(largest, std::abs(expected));
          displacement_error    = std::max(
            displacement_error,
            std::abs(grid_state.displacement(alpha, i % 2)[i / 2] - expected));
        }

  // a quarter of the cell from -80 to -40 and 45 to 90 degrees
  const double degree = numbers::PI / 180;
  const auto   child =
    grid_state.resultants({{Point<2>(-80 * degree, 45 * degree),
                            Point<2>(-60 * degree, 45 * degree),
                            Point<2>(-80 * degree, 67.5 * degree),
                            Point<2>(-60 * degree, 67.5 * degree)}},
                          0);

  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  check_small("displacements", displacement_error, 1e-12, largest);
  check_small("contact at a node of the seam",
              grid_state.contact(Point<2>(0., -numbers::PI)) - 1,
              1e-12);
  check_small("half of it beside the seam",
              grid_state.contact(Point<2>(0., 180 * degree - 22.5 * degree)) -
                0.5,
              1e-12);
  check_small("constant resultant", child[0] + 80 * degree, 1e-12);
  check_small("mean of the linear one in the quarter", child[1] + 4, 1e-12);
  check_small("its slope there", child[Modes::mode_of[1][1]] - 4, 1e-12);
}
