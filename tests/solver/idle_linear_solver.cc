// SPDX-License-Identifier: LGPL-2.1-or-later

// An iteration whose linear solver gives no update has not converged while the
// forces are far from balance.

#include <deal.II/base/timer.h>

#include <iostream>

#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/state/loads.h>
#include <biface/solver/newton.h>

#include "../model/coarse_torus.h"
#include "idle_solver.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout, false);
  TimerOutput timer(out, TimerOutput::never, TimerOutput::wall_times);

  const Layup              layup(Layup::Parameters(), cord_ply());
  const auto               mesh = coarse_torus(layup);
  const ContactInteraction contact(*mesh, ContactParameters());
  ShellEquations           equations(*mesh, make_force_terms(*mesh, contact));
  State                    state(*mesh);

  Newton::Parameters parameters;
  IdleSolver         solver;
  Newton             newton(
    parameters, equations, contact, solver, out, timer, Newton::Stop());

  ParametrizedLoads loads;
  loads.at = [](const LoadParameters &factor) {
    Loads loads;
    loads.pressure = 0.15 * factor[0];
    return loads;
  };
  LoadParameters     factor{1};
  const NewtonResult result =
    newton.solve(state, loads, factor, NewtonIteration::mixed);
  std::cout << (result.converged ? "converged" : result.failure.message)
            << std::endl;
}
