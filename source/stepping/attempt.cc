// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>

#include <biface/stepping/attempt.h>

namespace Biface
{
  Attempt
  attempt_step(Newton                                     &newton,
               const StageRun                             &run,
               const Control::Trial                       &trial,
               const InitialGuess                         &guess,
               const NewtonIteration                       iteration,
               const std::shared_ptr<const TangentialLaw> &law)
  {
    Attempt attempt;
    attempt.state         = guess.state;
    attempt.mu            = guess.mu;
    const LoadLevel &from = run.progress.reached, to = trial.level(guess.mu);
    attempt.state.time_step = {to.time - from.time,
                               run.loads_at(to, law).rolling
                                 ? to.temperature
                                 : (from.temperature + to.temperature) / 2};
    const ParametrizedLoads loads{[&](const LoadParameters &mu) {
                                    return run.loads_at(trial.level(mu), law);
                                  },
                                  trial.equations.get()};
    attempt.result = newton.solve(
      attempt.state, loads, attempt.mu, iteration, guess.zone_given);
    attempt.level = trial.level(attempt.mu);
    if (!attempt.result.converged)
      return attempt;
    const std::string passed =
      run.contact.passed_body(run.state,
                              run.loads_at(run.progress.reached),
                              attempt.state,
                              run.loads_at(attempt.level));
    if (!passed.empty())
      {
        attempt.result.converged = false;
        attempt.result.failure   = {FailureCause::divergence,
                                    "the shell has passed through the body '" +
                                      passed + "' in one step"};
      }
    return attempt;
  }
} // namespace Biface
