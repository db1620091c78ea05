// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <optional>

#include <biface/stepping/friction_continuation.h>

namespace Biface
{
  using namespace dealii;

  Attempt
  attempt_with_larger_critical_velocities(Newton               &newton,
                                          const StageRun       &run,
                                          const Control::Trial &trial,
                                          const Attempt        &failed,
                                          ConditionalOStream   &out)
  {
    // as a part of the speed: nearly viscous friction
    constexpr double       first        = 0.25;
    constexpr unsigned int max_attempts = 16;

    // another branch may be found, so that halving comes first
    if (!run.stage.contact || !run.law->critical_velocity() ||
        run.control->can_cut())
      return failed;
    out << "  not converged: " << failed.result.failure.message
        << "; trying larger critical velocities" << std::endl;
    InitialGuess guess{run.state, trial.mu};
    unsigned int iterations = failed.result.iterations;
    const double given      = *run.law->critical_velocity();
    const double speed      = std::abs(trial.level(trial.mu).ground_velocity);
    double       velocity = std::max(first * speed, 256 * given), ratio = 4;
    std::optional<double> last;
    for (unsigned int i = 0; i < max_attempts; ++i)
      {
        out << "  critical velocity " << velocity << std::endl;
        Attempt attempt =
          attempt_step(newton,
                       run,
                       trial,
                       guess,
                       newton.parameters.iteration,
                       run.law->with_critical_velocity(velocity));
        iterations += attempt.result.iterations;
        attempt.result.iterations = iterations;
        if (attempt.result.stopped ||
            (attempt.result.converged && velocity == given))
          return attempt;
        if (attempt.result.converged)
          {
            guess = {attempt.state, attempt.mu};
            last  = velocity;
          }
        else if (last)
          ratio = std::sqrt(ratio);
        else
          break;
        velocity = std::max(given, *last / ratio);
      }
    Attempt result           = failed;
    result.result.iterations = iterations;
    return result;
  }
} // namespace Biface
