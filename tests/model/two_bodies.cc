// SPDX-License-Identifier: LGPL-2.1-or-later

// A plate between two rigid planes, one on each face, is compressed as the
// strain of its thickness says, and what one plane exerts sideways by friction
// the other one balances.

#include <deal.II/base/timer.h>

#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/problem/parameters.h>
#include <biface/problem/shell_model.h>
#include <biface/solver/linear/eigenpairs.h>
#include <biface/solver/linear/make_linear_solver.h>
#include <biface/solver/newton.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr double E = 10, h = 2, length = 20, width = 10, epsilon = 500;

  ContactParameters
  plane(const Resultants::Face face)
  {
    ContactParameters parameters;
    parameters.face                = face;
    parameters.body.line.direction = Tensor<1, 3>({0, 0, 1});
    parameters.body.line.direction *= (face == Resultants::outer ? 1 : -1);
    parameters.condition.penalty_stiffness = epsilon;
    parameters.friction.coefficient = FrictionCoefficient("Friction", "0.5");
    parameters.friction.tangential_stiffness = 5;
    return parameters;
  }


  /** The pressure under which the thickness and both penetrations give way by
   * the given distance. */
  double
  pressure(const double distance)
  {
    double low = 0, high = E;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double p       = (low + high) / 2;
        const double stretch = 1 - (distance - 2 * p / epsilon) / h;
        const double S_33    = E * (stretch * stretch - 1) / 2;
        (-S_33 * stretch > p ? low : high) = p;
      }
    return low;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               no_output(std::cout, false);
  TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);

  Parameters       parameters;
  ParameterHandler prm;
  read_parameters(
    DATA_DIR "/squeezed_plate.prm", {}, MPI_COMM_WORLD, parameters, prm);
  const auto               mesh = make_shell_mesh(parameters, MPI_COMM_WORLD);
  const ContactInteraction contact(
    *mesh, {plane(Resultants::outer), plane(Resultants::inner)});
  ShellEquations equations(*mesh, make_force_terms(*mesh, contact));
  const auto     solver =
    make_linear_solver(LinearSolver::Parameters(), *mesh, timer);
  Newton newton(
    Newton::Parameters(), equations, contact, *solver, no_output, timer);

  // both planes approach; the upper one then slides
  const double approach = 0.1, slide = 0.01;
  State        state    = contact.unloaded_state();
  const auto   loads_at = [&](const double slide) {
    Loads loads;
    for (const auto &pair : contact.pairs)
      {
        RigidBody body = pair->moving_body.after_travel(
          travel_at_first_contact(*pair, contact.unloaded_state()) + approach);
        if (pair->face == Resultants::outer)
          body = body.displaced(Tensor<1, 3>({slide, 0, 0}), 0, Point<3>());
        loads.place(pair->number, {body, pair->laws()});
      }
    return loads;
  };
  const auto solve = [&](const Loads &loads) {
    ParametrizedLoads path;
    path.at = [&](const LoadParameters &) { return loads; };
    LoadParameters none;
    return newton.solve(state, path, none, NewtonIteration::mixed).converged;
  };
  // nodes in contact stick from the start: nothing else holds the plate
  contact.settle(state, loads_at(0));
  for (const auto &pair : contact.pairs)
    pair->commit_step(state, loads_at(0));
  const bool           squeezed = solve(loads_at(0));
  const ContactSummary outer = summarize(*contact.pairs[0], state, loads_at(0)),
                       inner = summarize(*contact.pairs[1], state, loads_at(0));
  equations.commit_step(state, loads_at(0), {0, 1}, state);
  const bool                slid = solve(loads_at(slide));
  std::vector<Tensor<1, 3>> forces;
  for (const auto &pair : contact.pairs)
    {
      Tensor<1, 3> force;
      for (const Cell &cell : mesh->cells)
        for (const unsigned int n : cell.nodes)
          force +=
            cell.geometry.weight / 4 *
            pair->traction_of_multipliers(state, loads_at(slide), n).total;
      forces.push_back(Utilities::MPI::sum(force, MPI_COMM_WORLD));
    }
  const unsigned int n_active = contact.count_active(state);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  const double p = pressure(2 * approach), force = p * length * width;
  check_true("both steps converge", squeezed && slid);
  check_small("force on the outer face", outer.force - force, 1e-8, force);
  check_small("force on the inner face", inner.force - force, 1e-8, force);
  check_small("pressure", outer.max_pressure - p, 1e-8, p);
  check_true("all nodes of both faces touch", n_active == 2 * mesh->n_nodes());
  check_range("friction (N)", forces[0][0], 0.1, 0.5 * force);
  check_small("sum of both", (forces[0] + forces[1]).norm(), 1e-8, force);
}
