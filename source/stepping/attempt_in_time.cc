// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <biface/input/parameter_tools.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/energy_of_motion.h>
#include <biface/stepping/attempt_in_time.h>
#include <biface/stepping/stage_run.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Whether the value of a load in the middle of a step is not its mean in
     * the step. */
    bool
    loads_change_unevenly(const Control::Trial &trial, const LoadLevel &middle)
    {
      // of the largest value in the step
      constexpr double remarkable = 0.1;

      const QGauss<1>     rule(8);
      const unsigned int  n_factors = middle.factors.size();
      std::vector<double> mean(n_factors + 1), largest(n_factors + 1);
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const LoadLevel level =
            trial.level({trial.mu[0] - (1 - rule.point(q)[0]) * trial.size});
          for (unsigned int i = 0; i <= n_factors; ++i)
            {
              const double value =
                (i < n_factors ? level.factors[i] : level.pressure);
              mean[i] += rule.weight(q) * value;
              largest[i] = std::max(largest[i], std::abs(value));
            }
        }
      for (unsigned int i = 0; i <= n_factors; ++i)
        if (!(std::abs(mean[i] -
                       (i < n_factors ? middle.factors[i] : middle.pressure)) <=
              remarkable * largest[i]))
          return true;
      return false;
    }
  } // namespace


  Attempt
  attempt_step_in_time(Newton               &newton,
                       const StageRun       &run,
                       const Control::Trial &trial)
  {
    const LoadLevel level  = trial.level(trial.mu);
    const auto      step   = std::make_shared<StepInTime>();
    step->start            = run.state;
    step->loads_at_start   = run.loads_at(run.progress.reached);
    step->duration         = level.time - run.progress.reached.time;
    step->damping          = run.stage.damping_in_time;
    const LoadLevel middle = trial.level({trial.mu[0] - trial.size / 2});
    step->middle.pressure  = middle.pressure;
    step->middle.factors   = middle.factors;

    Attempt attempt;
    attempt.mu    = trial.mu;
    attempt.level = level;
    if (run.stage.time_error > 0 && loads_change_unevenly(trial, middle))
      {
        attempt.result.failure = {FailureCause::error_in_time,
                                  "the loads change too unevenly in the step"};
        attempt.error_in_time  = 4 * run.stage.time_error;
        return attempt;
      }
    attempt.state           = run.state;
    attempt.state.step      = step;
    attempt.state.time_step = run.time_step_to(level);
    // a temporary would be moved, without the entries of ghosts
    const LA::Vector guess     = extrapolated(run.state, step->duration);
    attempt.state.displacement = guess;

    const Loads             loads = run.loads_at(level);
    const ParametrizedLoads given{
      [&loads](const LoadParameters &) { return loads; }};
    NewtonResult &result = attempt.result;
    // whether points stick or slip is decided with each increment, except after
    // the last one
    constexpr unsigned int max_rounds = 5;
    unsigned int           spent      = 0;
    for (unsigned int round = 0;; ++round)
      {
        result = newton.solve(
          attempt.state, given, attempt.mu, NewtonIteration::substituted);
        result.iterations += spent;
        spent = result.iterations;
        if (!result.converged ||
            run.contact.settle(attempt.state, loads) == 0 ||
            !run.contact.has_friction(loads))
          break;
        if (round == max_rounds)
          {
            result.converged = false;
            result.failure   = {FailureCause::contact_cycle,
                                "points stick and slip in turn"};
          }
      }
    // those of the tangent with inertia say nothing about an equilibrium
    result.n_negative_pivots.reset();
    if (!result.converged)
      return attempt;

    const std::string passed = run.contact.passed_body(
      run.state, step->loads_at_start, attempt.state, loads);
    if (!passed.empty())
      {
        result.converged = false;
        result.failure   = {FailureCause::other_solution,
                            "the shell has passed through the body '" + passed +
                              "' in one step"};
        return attempt;
      }
    if (run.stage.time_error == 0)
      return attempt;
    // steps whose error is twice the one that is wanted count as well
    constexpr double largest = 2;
    attempt.error_in_time    = error_in_time(run.equations, attempt.state);
    if (!(attempt.error_in_time <= largest * run.stage.time_error))
      {
        result.converged = false;
        result.failure   = {FailureCause::error_in_time,
                            "the step is too long: its error in time is " +
                              number_to_string(attempt.error_in_time)};
      }
    return attempt;
  }


  std::shared_ptr<const NodalForces>
  forces_over_step(const StageRun &run, const Attempt &attempt)
  {
    return std::make_shared<const NodalForces>(run.equations.nodal_forces(
      attempt.state,
      run.equations.with_dependent_loads(attempt.state,
                                         run.loads_at(attempt.level))));
  }


  Work
  end_step_in_time(const StageRun                          &run,
                   const std::shared_ptr<const StepInTime> &step,
                   const Loads                             &loads,
                   const NodalForces                       &forces,
                   State                                   &state)
  {
    const LA::Vector velocity = step->velocity(state);
    state.velocity            = run.equations.mesh.ghosted_vector();
    state.velocity            = velocity;
    state.step                = step;
    remember_motion(run.equations, state);
    const Work work =
      work_in_time(run.equations, run.contact, state, loads, forces);
    state.step.reset();
    return work;
  }
} // namespace Biface
