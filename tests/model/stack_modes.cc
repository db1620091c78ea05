// SPDX-License-Identifier: LGPL-2.1-or-later

// A free stack of one to four layers has six modes without energy, the rigid
// motions, and the conditioning of a thin one does not depend on the number of
// its layers.

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/state/loads.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/plane.h>

#include "cord_shells.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The eigenvalues of the stiffness of a plate, scaled by its diagonal, in
   * ascending order. */
  std::vector<double>
  eigenvalues(const std::string                &ply,
              const std::string                &layers,
              const std::array<std::string, 2> &intervals,
              const std::string                &edge)
  {
    Layup::Parameters parameters;
    parameters.plies  = parse_plies("plies", ply);
    parameters.layers = parse_layers("layers", layers);
    ChartGrid::Parameters grid;
    for (unsigned int a = 0; a < 2; ++a)
      grid.intervals[a] = parse_intervals("intervals", intervals[a]);
    grid.closed = false;
    Supports supports;
    supports.edges[0]                          = parse_support("edge", edge, 0);
    auto                                 plane = std::make_unique<Plane>();
    const ChartGrid                      chart(grid, *plane);
    const ShellMesh                      mesh(MPI_COMM_WORLD,
                         std::move(plane),
                         chart,
                         Layup(parameters, cord_ply()),
                         supports,
                         {});
    std::vector<types::global_dof_index> dofs;
    for (const Node &node : mesh.nodes)
      for (const auto dof : node.dofs)
        if (!mesh.constraints.is_constrained(dof))
          dofs.push_back(dof);

    const ContactInteraction contact(mesh, ContactParameters());
    ShellEquations           equations(mesh, make_force_terms(mesh, contact));
    equations.assemble(State(mesh), Loads());
    const auto              &tangent = equations.tangent();
    LAPACKFullMatrix<double> matrix(dofs.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      for (unsigned int j = 0; j < dofs.size(); ++j)
        matrix(i, j) = tangent.el(dofs[i], dofs[j]) /
                       std::sqrt(tangent.diag_element(dofs[i]) *
                                 tangent.diag_element(dofs[j]));
    Vector<double>     all;
    FullMatrix<double> vectors;
    matrix.compute_eigenvalues_symmetric(-1e3, 1e3, 0, all, vectors);
    return {all.begin(), all.end()};
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string layers :
       {"1", "1/2, 1/2", "1/3, 1/3, 1/3", "1/4, 1/4, 1/4, 1/4"})
    {
      const auto modes =
        eigenvalues("cord: 0.4 @ 30", layers, {{"0:2:3", "0:1:2"}}, "free");
      std::cout << "layers: " << layers << std::endl;
      const double largest = modes.back();
      check_small("  lowest eigenvalue", modes[0], 1e-13, largest);
      check_small("  sixth", modes[5], 1e-13, largest);
      check_range("  seventh", modes[6] / largest, 1e-5, 1);
    }

  // a strip a thousand times as long as thick
  double of_one_layer = 0;
  for (const std::string layers :
       {"1", "1/3, 1/3, 1/3", "1/9, 1/9, 1/9, 1/9, 1/9, 1/9, 1/9, 1/9, 1/9"})
    {
      const auto modes =
        eigenvalues("cord: 1 @ 0", layers, {{"0:1000:20", "0:50:1"}}, "fixed");
      const double condition = modes.back() / modes.front();
      if (of_one_layer == 0)
        of_one_layer = condition;
      std::cout << "layers: " << layers << std::endl;
      check_range("  conditioning", condition / of_one_layer, 0.5, 2);
    }
}
