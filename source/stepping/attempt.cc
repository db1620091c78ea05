// SPDX-License-Identifier: LGPL-2.1-or-later

#include <memory>
#include <string>

#include <biface/contact/rolling.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/heat/heat_of_plies.h>
#include <biface/model/quantities/hysteresis.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/attempt.h>
#include <biface/stepping/stage_run.h>

namespace Biface
{
  namespace
  {
    /** After rolling with given temperatures, compute these and rolling in
     * turn, until they settle. */
    void
    settle_heat(Newton                  &newton,
                const StageRun          &run,
                const RollingHeat       &heat,
                const ParametrizedLoads &loads,
                const NewtonIteration    iteration,
                Attempt                 &attempt)
    {
      constexpr double       tolerance  = 1e-6;
      constexpr unsigned int max_rounds = 50;

      RollingHeat::Iteration temperatures(heat);
      // the footprint of the first round: a node that touches and leaves in
      // turn would keep the temperatures from settling
      const std::vector<double> parts  = heat.parts_in_contact(attempt.state);
      NewtonResult             &result = attempt.result;
      while (result.converged)
        {
          const Loads now = loads.at(attempt.mu);
          ++attempt.n_heat_rounds;
          if (temperatures.advance(
                heat.field(find_hysteresis(run.equations,
                                           attempt.state,
                                           now.rolling->angular_velocity),
                           parts,
                           now),
                tolerance,
                attempt.state))
            return;
          if (attempt.n_heat_rounds == max_rounds)
            {
              result.converged = false;
              result.failure   = {FailureCause::heat,
                                  "the temperatures of the plies have not "
                                    "settled in " +
                                    std::to_string(max_rounds) + " rounds"};
              return;
            }
          const unsigned int spent = result.iterations;
          result = newton.solve(attempt.state, loads, attempt.mu, iteration);
          result.iterations += spent;
        }
    }
  } // namespace


  Attempt
  attempt_step(Newton               &newton,
               const StageRun       &run,
               const Control::Trial &trial,
               const InitialGuess   &guess,
               const NewtonIteration iteration,
               const ContactLaws    &laws)
  {
    Attempt attempt;
    attempt.state = guess.state;
    attempt.mu    = guess.mu;
    // without contact there are no losses
    const bool loses_energy = run.rolls && run.stage.contact;
    if (!loses_energy)
      attempt.state.terms.erase("heat");
    attempt.state.time_step = run.time_step_to(trial.level(guess.mu));
    attempt.state.rolling_step =
      run.rolling_step(attempt.state.time_step.duration);
    const ParametrizedLoads loads{[&](const LoadParameters &mu) {
                                    Loads result =
                                      run.loads_at(trial.level(mu), laws);
                                    // steps without a size have no damping
                                    result.part_of_stage =
                                      trial.size > 0 ? trial.size : 1.;
                                    return result;
                                  },
                                  trial.equations.get()};
    attempt.result = newton.solve(
      attempt.state, loads, attempt.mu, iteration, guess.zone_given);
    if (loses_energy && run.heat && run.heat->is_coupled())
      settle_heat(newton, run, *run.heat, loads, iteration, attempt);
    // those of the tangent with dashpots say nothing about an equilibrium
    if (run.stage.damping > 0)
      attempt.result.n_negative_pivots.reset();
    attempt.level = trial.level(attempt.mu);
    if (!attempt.result.converged)
      return attempt;
    // beyond the body the shell is in equilibrium, too, but no motion leads
    // there
    const std::string passed =
      run.contact.passed_body(run.state,
                              run.loads_at(run.progress.reached),
                              attempt.state,
                              run.loads_at(attempt.level));
    if (!passed.empty())
      {
        attempt.result.converged = false;
        attempt.result.failure   = {FailureCause::other_solution,
                                    "the shell has passed through the body '" +
                                      passed + "' in one step"};
      }
    return attempt;
  }


  Attempt
  attempt_step(Newton               &newton,
               const StageRun       &run,
               const Control::Trial &trial,
               const InitialGuess   &guess,
               const NewtonIteration iteration)
  {
    return attempt_step(newton, run, trial, guess, iteration, run.laws);
  }
} // namespace Biface
