// SPDX-License-Identifier: LGPL-2.1-or-later

// A load that nothing resists is not taken for round-off, however far the shell
// has moved.

#include <deal.II/base/timer.h>

#include <iostream>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/solver/newton.h>

#include "../model/cord_shells.h"
#include "idle_solver.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout, false);
  TimerOutput timer(out, TimerOutput::never, TimerOutput::wall_times);

  // without supports, and moved as a whole
  const auto               mesh = plate();
  const ContactInteraction contact(*mesh, ContactParameters());
  ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));
  State                    state(*mesh);
  LA::Vector               distance = mesh->owned_vector();
  for (const Node &node : mesh->nodes)
    for (unsigned int i = 0; i < 3; ++i)
      distance(node.dof(i, MixedElement::mean)) = 1e8;
  state.displacement = distance;

  ParametrizedLoads loads;
  loads.at = [](const LoadParameters &) {
    Loads loads;
    loads.pressure = 1e-6;
    return loads;
  };
  equations.assemble(state, loads.at({0}));
  check_true("round-off may be as large as the load",
             equations.relative_roundoff(state) >
               equations.relative_residual());

  IdleSolver solver;
  Newton newton(Newton::Parameters(), equations, contact, solver, out, timer);
  LoadParameters     mu{0};
  const NewtonResult result =
    newton.solve(state, loads, mu, NewtonIteration::mixed);
  std::cout << (result.converged ? "converged" : result.failure.message)
            << std::endl;
}
