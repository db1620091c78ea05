// SPDX-License-Identifier: LGPL-2.1-or-later

// The substituted iteration finds the equilibrium of the mixed one, for an
// inflated shell in contact and every element.

#include <deal.II/base/timer.h>

#include <array>
#include <iostream>

#include <biface/laminate/layup.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/solver/linear/make_linear_solver.h>
#include <biface/solver/newton.h>

#include "../model/coarse_torus.h"
#include <cord_ply.h>
#include <name_of.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const Formulation formulation)
  {
    ConditionalOStream no_output(std::cout, false);
    TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);

    const Layup       layup(Layup::Parameters(), cord_ply());
    const auto        mesh = coarse_torus(layup, formulation);
    ContactParameters parameters;
    parameters.condition.penalty_stiffness = 10;
    const ContactInteraction contact(*mesh, parameters);
    PressureLoad             pressure;
    pressure.kind = PressureKind::dead;
    ShellEquations equations(
      *mesh, make_force_terms(*mesh, contact, DeadLoads(), pressure));
    const auto solver =
      make_linear_solver(LinearSolver::Parameters(), *mesh, timer);
    Newton newton(
      Newton::Parameters(), equations, contact, *solver, no_output, timer);

    ParametrizedLoads loads;
    loads.at = [&](const LoadParameters &part) {
      Loads result;
      result.pressure = 0.15 * part[0];
      result.place(
        0,
        {contact.ground().moving_body.after_travel(
           travel_at_first_contact(contact.ground(), contact.unloaded_state()) +
           4 * part[0]),
         contact.ground().laws()});
      return result;
    };

    std::array<State, 2>                 states;
    const std::array<NewtonIteration, 2> iterations{
      {NewtonIteration::mixed, NewtonIteration::substituted}};
    bool converged = true;
    for (unsigned int k = 0; k < 2; ++k)
      {
        states[k] = contact.unloaded_state();
        for (const double part : {0.5, 1.})
          {
            LoadParameters mu{part};
            converged =
              newton.solve(states[k], loads, mu, iterations[k]).converged &&
              converged;
          }
      }
    LA::Vector difference = mesh->owned_vector(), mixed = difference;
    mixed      = states[0].displacement;
    difference = states[1].displacement;
    difference -= mixed;
    check_true(name_of(formulation) + ": both converge", converged);
    check_small("  difference of displacements",
                difference.linfty_norm(),
                1e-7,
                mixed.linfty_norm());
    check_range("  nodes in contact",
                contact.count_active(states[0]),
                3,
                mesh->n_nodes() / 2);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto formulation :
       {Formulation::paper, Formulation::vertices, Formulation::standard})
    test(formulation);
}
