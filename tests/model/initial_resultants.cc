// SPDX-License-Identifier: LGPL-2.1-or-later

// Initial resultants that are formulas of the position do the work by hand on
// the nonlinear part of the strains: on a plate whose nodes go up by w = a x +
// b y, 2 eta_11 = a^2, 2 eta_22 = b^2 and eta_12 = a b on both faces.

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

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double a = 0.3, b = -0.2;


  /** The work of the forces of a plate of size 4 by 2 on its displacements. */
  double
  work(const std::string &initial)
  {
    auto                  surface = std::make_unique<Plane>();
    ChartGrid::Parameters parameters;
    parameters.intervals = {{parse_intervals("intervals", "0:4:5:1.2"),
                             parse_intervals("intervals", "0:2:3")}};
    parameters.closed    = false;
    const ChartGrid   grid(parameters, *surface);
    Layup::Parameters layup;
    layup.initial_resultants = parse_initial_resultants("initial", initial);
    const ShellMesh mesh(MPI_COMM_WORLD,
                         std::move(surface),
                         grid,
                         Layup(layup, cord_ply()),
                         Supports(),
                         {});

    const ContactInteraction contact(mesh, ContactParameters());
    ShellEquations           equations(mesh, make_force_terms(mesh, contact));
    State                    state(mesh);
    LA::Vector               w = mesh.owned_vector();
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        w(node.dof(2, MixedElement::mean)) =
          a * node.alpha[0] + b * node.alpha[1];
    w.compress(VectorOperation::insert);
    state.displacement = w;
    equations.assemble(state, Loads());
    return -(equations.residual() * w);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double without = work("");
  const auto   check = [&](const std::string &initial, const double expected) {
    const double found = work(initial) - without;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      check_small(initial, found - expected, 1e-12, std::abs(without));
  };
  // integrals over the plate: of 1 it is 8, of x 16, of y 8, of x y 16
  check("H_11 both = 2 + x + 3*alpha_2", 2 * (16 + 16 + 24) * a * a);
  check("H_22 inner = x; H_22 outer = y", (16 + 8) * b * b);
  check("H_12 both = 1 - x", 2 * (8 - 16) * 2 * a * b);
  check("H_11 inner = 1; H_11 inner = 1", 2 * 8 * a * a);
  check("H_13 both = 1; H_23 both = x; H_33 = 1", 0);
  return 0;
}
