// SPDX-License-Identifier: LGPL-2.1-or-later

// With forces in balance, a step has not converged while the equation for its
// load parameter is not satisfied.

#include <deal.II/base/timer.h>

#include <iostream>

#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/state/loads.h>
#include <biface/solver/linear/make_linear_solver.h>
#include <biface/solver/newton.h>

#include "../model/coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The part of the pressure is to be 1; a wrong derivative tells the
   * iteration to leave it as it is. */
  class StuckEquation : public ControlEquation
  {
  public:
    explicit StuckEquation(const double violation)
      : ControlEquation(LoadRates()), how_far(violation)
    {}

    double
    parameter_change(const Iteration &,
                     const LA::Vector &,
                     const LA::Vector &) const override
    {
      return 0;
    }

    double
    violation(const Iteration &) const override
    {
      return how_far;
    }

  private:
    const double how_far;
  };
} // namespace


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
  const auto               solver =
    make_linear_solver(LinearSolver::Parameters(), *mesh, timer);
  Newton newton(Newton::Parameters(), equations, contact, *solver, out, timer);

  for (const double violation : {1e-9, 1e-3})
    {
      const StuckEquation equation(violation);
      ParametrizedLoads   loads;
      loads.equations = &equation;
      loads.at        = [](const LoadParameters &part) {
        Loads loads;
        loads.pressure = 0.15 * part[0];
        return loads;
      };
      State              state(*mesh);
      LoadParameters     part{0.5};
      const NewtonResult result =
        newton.solve(state, loads, part, NewtonIteration::mixed);
      check_true("the forces are in balance", result.residuals.back() < 1e-8);
      std::cout << "violated by " << violation << ": "
                << (result.converged ? "converged" : result.failure.message)
                << std::endl;
    }
}
