// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include <biface/contact/contact_laws.h>
#include <biface/contact/friction.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/friction_continuation.h>
#include <biface/stepping/stage_run.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Laws between the given ones, at 1, and easier ones. */
    struct EasierLaws
    {
      /** Where to start, above 1. */
      double                                   first;
      std::function<FrictionLaw(const double)> at;
      std::function<std::string(const double)> name;
    };


    /** None without steady friction. */
    std::optional<EasierLaws>
    easier_laws(const ContactLaws &given, const double speed)
    {
      // little friction hardly acts back on the footprint, and with a large
      // critical velocity it is nearly linear in the slip velocity
      if (given.kind_of_friction() == FrictionKind::by_bristles)
        return EasierLaws{
          16,
          [&given](const double easing) {
            return given.friction().with_part_of_friction(1 / easing);
          },
          [](const double easing) {
            return "friction times " + number_to_string(1 / easing);
          }};
      if (given.kind_of_friction() != FrictionKind::by_slip_velocity)
        return {};
      // as a part of the speed: nearly viscous friction
      constexpr double first    = 0.25;
      const double     velocity = given.friction().critical_velocity();
      return EasierLaws{
        std::max(first * speed / velocity, 256.),
        [&given, velocity](const double easing) {
          return given.friction().with_critical_velocity(easing * velocity);
        },
        [velocity](const double easing) {
          return "critical velocity " + number_to_string(easing * velocity);
        }};
    }
  } // namespace


  Attempt
  attempt_with_easier_friction(Newton               &newton,
                               const StageRun       &run,
                               const Control::Trial &trial,
                               const Attempt        &failed,
                               ConditionalOStream   &out)
  {
    constexpr unsigned int max_attempts = 16;

    const auto laws =
      easier_laws(run.laws, std::abs(trial.level(trial.mu).ground_velocity));
    if (!run.stage.contact || !laws)
      return failed;
    // another branch may be found, so that halving comes first; the problem of
    // a standing wheel on bristles is the same at any speed, unless it rolls a
    // shorter way in a shorter step
    const bool halving_helps = !run.laws.bristles() ||
                               run.progress.reached.rolls() ||
                               run.stage.transient_rolling;
    if (halving_helps && run.control->can_cut())
      return failed;
    out << "  not converged: " << failed.result.failure.message
        << "; trying easier laws of friction" << std::endl;
    InitialGuess          guess{run.state, trial.mu};
    unsigned int          iterations = failed.result.iterations;
    double                easing = laws->first, ratio = 4;
    std::optional<double> last;
    for (unsigned int i = 0; i < max_attempts; ++i)
      {
        out << "  " << laws->name(easing) << std::endl;
        Attempt attempt = attempt_step(
          newton,
          run,
          trial,
          guess,
          NewtonIteration::mixed,
          easing > 1 ? run.laws.with_friction(laws->at(easing)) : run.laws);
        iterations += attempt.result.iterations;
        attempt.result.iterations = iterations;
        if (attempt.result.stopped || (attempt.result.converged && easing == 1))
          return attempt;
        if (attempt.result.converged)
          {
            guess = {attempt.state, attempt.mu};
            last  = easing;
          }
        else if (last)
          ratio = std::sqrt(ratio);
        else
          break;
        // from the last solution, by a smaller step after each failure
        easing = std::max(1., *last / ratio);
      }
    // what fails are the given laws, and advice refers to them
    Attempt result           = failed;
    result.result.iterations = iterations;
    if (run.laws.bristles())
      {
        Failure     &failure = result.result.failure;
        std::string &remedies =
          (halving_helps ? failure.further_remedies : failure.remedies);
        remedies = "softer bristles, by a smaller '" +
                   run.stage.in_use(run.progress.stage)
                     .section_of_tangential_regularization +
                   "/Tangential regularization' or a 'Contact/Tread'";
        if (last)
          remedies += "; less 'Friction', since the step converged with " +
                      laws->name(*last);
      }
    return result;
  }
} // namespace Biface
