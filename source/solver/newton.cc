// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <biface/input/parameter_tools.h>
#include <biface/solver/active_set_iteration.h>
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
                 TimerOutput        &timer,
                 const Stop         &stop)
    : parameters(parameters)
    , equations(equations)
    , linear_solver(linear_solver)
    , out(out)
    , timer(timer)
    , stop(stop)
  {}


  namespace
  {
    /**
     * How exactly to solve the next linear system, in the solver's own norm
     * @cite EisenstatWalker1996: as the residual has fallen, squared, but no
     * further than the last iteration needs, and at least to @p greatest.
     */
    double
    forcing_term(const std::vector<double> &residuals,
                 const double               tolerance,
                 const double               greatest)
    {
      constexpr double gamma = 0.9;

      const double now = residuals.back();
      if (residuals.size() < 2 || now == 0)
        return greatest;
      const double ratio = now / residuals[residuals.size() - 2];
      return std::min(
        greatest,
        std::max({gamma * ratio * ratio, 0.1 * tolerance / now, 1e-10}));
    }
  } // namespace


  NewtonResult
  Newton::solve(State                &state,
                const Path           &path,
                double               &number,
                const NewtonIteration iteration,
                const bool            zone_given)
  {
    const ShellMesh &mesh = equations.mesh;

    NewtonResult       result;
    ActiveSetIteration zone(equations, out);
    Loads              loads     = path.loads(number);
    unsigned int       n_changes = (zone_given ? 0 : zone.update(state, loads));
    double             last_update = std::numeric_limits<double>::infinity();
    LA::Vector         increment   = mesh.owned_vector();
    LA::Vector         total       = mesh.owned_vector();

    const auto fail = [&](const FailureCause cause, const std::string &why) {
      result.cause   = cause;
      result.message = why;
      return result;
    };
    const auto print = [&](const std::string &update) {
      char line[128];
      std::snprintf(line,
                    sizeof(line),
                    "    iteration %2u  residual %9.3e  update %9s  active %4u"
                    "  changes %4u",
                    result.iterations,
                    result.residuals.back(),
                    update.c_str(),
                    equations.count_active(state),
                    n_changes);
      out << line << std::endl;
    };

    while (true)
      {
        if (stop && stop())
          {
            result.message = "stopped";
            result.stopped = true;
            return result;
          }
        {
          TimerOutput::Scope scope(timer, "Assembly");
          equations.assemble(state, loads);
        }
        result.residuals.push_back(equations.relative_residual());
        if (!std::isfinite(result.residuals.back()))
          return fail(FailureCause::divergence, "the residual is not a number");

        // a condition on the path needs an iteration to be satisfied
        const bool at_rest =
          (result.iterations == 0 ? path.control == nullptr && !zone_given
                                  : n_changes == 0);
        const double small = parameters.update_tolerance * mesh.thickness();
        if (at_rest &&
            equations.support_violation() <=
              std::max(small, 1e-12 * mesh.size()) &&
            (result.residuals.back() <= parameters.residual_tolerance ||
             // with forces far from balance, no update means no solution
             (last_update <= small && result.residuals.back() <= 1e-3) ||
             result.residuals.back() <= equations.relative_roundoff(state)))
          {
            n_changes = zone.release(state, loads);
            if (n_changes > 0)
              {
                result.residuals.pop_back();
                continue;
              }
            result.converged = true;
            break;
          }
        if (result.iterations == parameters.max_iterations)
          return fail(FailureCause::too_many_iterations,
                      "no convergence in " + std::to_string(result.iterations) +
                        " iterations");

        LinearSolverResult linear = linear_solver.factorize(
          equations.tangent(), equations.is_symmetric());
        result.n_negative_pivots = linear.n_negative_pivots;
        // Small errors of large displacements make contact wander, which is
        // stiff. What begins on a coarser mesh has small ones left.
        const double exactness = forcing_term(result.residuals,
                                              parameters.residual_tolerance,
                                              zone_given ? 1e-3 : 1e-6);
        if (linear.success)
          linear =
            linear_solver.solve(increment, equations.residual(), exactness);
        if (linear.success)
          equations.distribute(increment);
        if (linear.success && path.control != nullptr)
          {
            const PathControl::Iteration here{equations, state, loads, total};
            LA::Vector                   per_load = mesh.owned_vector();
            linear                                = linear_solver.solve(
              per_load, path.control->load_direction(here), exactness);
            // supports hold still while the load grows
            mesh.constraints.distribute(per_load);
            const double change =
              path.control->load_change(here, increment, per_load);
            if (linear.success && !std::isfinite(change))
              return fail(FailureCause::control,
                          "what is controlled does not depend on the loads");
            increment.add(change, per_load);
            number += change;
            loads = path.loads(number);
          }
        if (!linear.success)
          return fail(linear.cause, linear.message);

        TimerOutput::Scope scope(timer, "Update of the state");
        total += increment;
        equations.update(state, increment, iteration);
        n_changes   = zone.update(state, loads);
        last_update = increment.linfty_norm();
        ++result.iterations;
        if (!(last_update <= 1e3 * mesh.size()))
          return fail(FailureCause::divergence,
                      "the iteration diverged: an update exceeded 1000 times "
                      "the size of the shell");
        if (!zone.failure().empty())
          return fail(FailureCause::contact_cycle, zone.failure());

        char update[16];
        std::snprintf(update, sizeof(update), "%9.3e", last_update);
        print(update);
      }

    TimerOutput::Scope scope(timer, "Update of the state");
    print("");
    equations.settle_resultants(state);
    return result;
  }
} // namespace Biface
