// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <cstdio>

#include <biface/base/parameter_tools.h>
#include <biface/solver/newton.h>

namespace Biface
{
  using namespace dealii;

  void
  Newton::Parameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Iteration",
               iteration,
               {"mixed", "substituted"},
               "'mixed' keeps the resultants of every element as unknowns of "
               "the iteration, which allows large steps; 'substituted' "
               "computes them from the displacements.");
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      "Iterations after which a step is given up.",
                      Patterns::Integer(1));
    prm.add_parameter("Residual tolerance",
                      residual_tolerance,
                      "A step has converged when the contact zone is at rest "
                      "and the residual, as a fraction of the forces that "
                      "cancel in it, is at most this. No unit.",
                      Patterns::Double());
    prm.add_parameter("Update tolerance",
                      update_tolerance,
                      "A step has also converged when the contact zone is at "
                      "rest and the largest nodal update, as a fraction of the "
                      "shell's thickness, is at most this. No unit.",
                      Patterns::Double());
  }


  void
  Newton::Parameters::check() const
  {
    check_positive("Newton/Residual tolerance", residual_tolerance);
    check_not_negative("Newton/Update tolerance", update_tolerance);
  }


  Newton::Newton(const Parameters   &parameters,
                 ShellEquations     &equations,
                 LinearSolver       &linear_solver,
                 ConditionalOStream &out,
                 TimerOutput        &timer)
    : parameters(parameters)
    , equations(equations)
    , linear_solver(linear_solver)
    , out(out)
    , timer(timer)
  {}


  NewtonResult
  Newton::solve(State                &state,
                const Loads          &loads,
                const NewtonIteration iteration)
  {
    const double thickness = equations.discretization.get_faces()[1] -
                             equations.discretization.get_faces()[0];

    NewtonResult result;
    unsigned int n_changes   = equations.update_active_set(state, loads);
    LA::Vector   increment   = equations.discretization.owned_vector();
    double       last_update = std::numeric_limits<double>::infinity();

    const auto print = [&](const std::string &update,
                           const unsigned int n_active) {
      char line[128];
      std::snprintf(line,
                    sizeof(line),
                    "    iteration %2u  residual %9.3e  update %9s  active %4u"
                    "  changes %4u",
                    result.iterations,
                    result.residuals.back(),
                    update.c_str(),
                    n_active,
                    n_changes);
      out << line << std::endl;
    };
    const auto count_active = [&]() {
      unsigned int n = 0;
      for (unsigned int i = 0; i < state.active.size(); ++i)
        if (state.active[i] && equations.discretization.nodes[i].locally_owned)
          ++n;
      return Utilities::MPI::sum(n, equations.discretization.communicator);
    };

    while (true)
      {
        {
          TimerOutput::Scope scope(timer, "Assembly");
          equations.assemble(state, loads);
        }
        result.residuals.push_back(equations.relative_residual());
        if (!std::isfinite(result.residuals.back()))
          {
            result.message = "the residual is not a number";
            return result;
          }

        const bool at_rest = (result.iterations == 0 || n_changes == 0);
        if (at_rest &&
            (result.residuals.back() <= parameters.residual_tolerance ||
             last_update <= parameters.update_tolerance * thickness))
          {
            result.converged = true;
            break;
          }
        if (result.iterations == parameters.max_iterations)
          {
            result.message = "no convergence in " +
                             std::to_string(result.iterations) + " iterations";
            return result;
          }

        const LinearSolverResult linear =
          linear_solver.solve(equations.tangent(),
                              increment,
                              equations.residual(),
                              equations.is_symmetric());
        if (!linear.success)
          {
            result.message = linear.message;
            return result;
          }
        equations.discretization.constraints.distribute(increment);

        {
          TimerOutput::Scope scope(timer, "Update of the state");
          equations.update(state, increment, iteration);
          n_changes   = equations.update_active_set(state, loads);
          last_update = increment.linfty_norm();
          ++result.iterations;

          if (!(last_update <= equations.discretization.size()))
            {
              result.message = "the iteration diverged: an update exceeded "
                               "the size of the shell";
              return result;
            }

          char update[16];
          std::snprintf(update, sizeof(update), "%9.3e", last_update);
          print(update, count_active());
        }
      }

    TimerOutput::Scope scope(timer, "Update of the state");
    print("", count_active());
    equations.settle_resultants(state);
    return result;
  }
} // namespace Biface
