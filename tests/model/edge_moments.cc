// SPDX-License-Identifier: LGPL-2.1-or-later

// The nodal forces of a dead moment along an edge are a pure couple, the moment
// times the length of the edge, which pushes the outer face outward beyond the
// edge; so are those of a follower moment in the undeformed shell. With several
// layers, also in one that is displaced by more than its thickness, where the
// moment about the edge of a follower moment remains the same.

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/state/loads.h>

#include "coarse_torus.h"
#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  check(const std::string  &what,
        const ShellMesh    &mesh,
        const std::string  &edge,
        const Tensor<1, 3> &moment)
  {
    for (const std::string kind : {"dead", "follower"})
      {
        DeadLoads loads;
        loads.edge_moments =
          parse_edge_moments("moments", edge + ": 3 " + kind);
        const ContactInteraction contact(mesh, ContactParameters());
        ShellEquations equations(mesh, make_force_terms(mesh, contact, loads));
        Loads          at;
        at.factors = {2};
        equations.assemble(State(mesh), at);
        const Total total(mesh, equations.residual());
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          {
            std::cout << what << ", " << edge << ", " << kind << std::endl;
            check_small("  force", total.force.norm(), 1e-12, 10);
            check_small("  moment", (total.moment - moment).norm(), 1e-12, 10);
          }
      }
  }


  /** The same for a follower moment about the axis of @p moment in a shell
   * whose nodes are displaced at random. */
  void
  check_displaced(const std::string  &what,
                  const ShellMesh    &mesh,
                  const std::string  &edge,
                  const Tensor<1, 3> &moment)
  {
    DeadLoads loads;
    loads.edge_moments = parse_edge_moments("moments", edge + ": 3 follower");
    const ContactInteraction contact(mesh, ContactParameters());
    const ShellEquations     equations(mesh,
                                   make_force_terms(mesh, contact, loads));
    State                    state(mesh);
    // named, since a temporary would be moved together with its partition
    const LA::Vector V = some_displacement(mesh, 2, 1);
    state.displacement = V;
    Loads at;
    at.factors = {2};
    const Total total(
      mesh,
      equations.nodal_forces(state, at)[ForceTerm::Source::loads],
      state.displacement);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::cout << what << ", " << edge << ", displaced" << std::endl;
        check_small("  force", total.force.norm(), 1e-12, 10);
        check_small("  moment about the edge",
                    (total.moment - moment) * moment / moment.norm(),
                    1e-12,
                    10);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // 2 times 3 times the length of 2 or 4; the outer face is above
  const auto flat = plate();
  check("plate", *flat, "alpha_1 min", Tensor<1, 3>({0, -12, 0}));
  check("plate", *flat, "alpha_1 max", Tensor<1, 3>({0, 12, 0}));
  check("plate", *flat, "alpha_2 min", Tensor<1, 3>({24, 0, 0}));
  check("plate", *flat, "alpha_2 max", Tensor<1, 3>({-24, 0, 0}));

  // layers of different stiffness along both coordinates, one of which ends
  // halfway; the outer face is that of the layer in the middle there
  const std::string plies =
    "cord: 0.2 @ 10, cord: 1 @ 60, cord: 0.3 @ 30 from 0 to 2.4";
  for (const std::string layers : {"one per ply", "1/2, 3/2, 1"})
    {
      const auto        stack = cord_shell(std::make_unique<Plane>(),
                                    {{"0:4:5", "0:2:3"}},
                                    false,
                                    plies,
                                    "0.5",
                                    {},
                                    {},
                                    layers);
      const std::string name  = "plate of layers " + layers;
      check(name, *stack, "alpha_1 min", Tensor<1, 3>({0, -12, 0}));
      check(name, *stack, "alpha_1 max", Tensor<1, 3>({0, 12, 0}));
      check(name, *stack, "alpha_2 min", Tensor<1, 3>({24, 0, 0}));
      check_displaced(name, *stack, "alpha_1 min", Tensor<1, 3>({0, -12, 0}));
      check_displaced(name, *stack, "alpha_2 max", Tensor<1, 3>({-24, 0, 0}));
    }

  // around a closed edge all balances; a generator has the length 6, the axis
  // of the moment is e_1 = y at the start and -y at the end
  const auto closed = cylinder("0:360:7", true);
  check("closed cylinder", *closed, "alpha_1 max", Tensor<1, 3>());
  const auto open = cylinder("0:90:3", false);
  check("open cylinder", *open, "alpha_2 min", Tensor<1, 3>({0, 36, 0}));
  check("open cylinder", *open, "alpha_2 max", Tensor<1, 3>({0, -36, 0}));
}
