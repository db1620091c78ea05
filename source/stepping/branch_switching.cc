// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>

#include <biface/stepping/branch_switching.h>
#include <biface/stepping/critical_point.h>
#include <biface/stepping/stage_run.h>

namespace Biface
{
  using namespace dealii;

  std::optional<Attempt>
  attempt_other_branch(Newton             &newton,
                       const StageRun     &run,
                       Control::Trial     &trial,
                       ConditionalOStream &out)
  {
    constexpr unsigned int max_attempts = 40, max_cuts = 6;

    const bool        to_given_loads = (trial.equations == nullptr);
    const double      target         = trial.mu[0];
    const LA::Vector &shape          = run.progress.branch;
    const auto        fail           = [&](const std::string &why) {
      out << "  the other branch was not found: " << why
          << "; the primary path is followed further" << std::endl;
      return std::nullopt;
    };

    // the amplitude of the shape is prescribed and the load unknown, section 9
    // of doc/theory.md: with given loads the iteration would return to the
    // primary path
    Control::Trial along = trial;
    along.size           = 0;
    Attempt reached;
    reached.state           = run.state;
    reached.mu              = {run.control->done()};
    unsigned int iterations = 0, n_cuts = 0;
    double       amplitude = 0;
    double       increment =
      run.stage.branch_amplitude * run.equations.mesh.thickness();
    for (unsigned int i = 0; i < max_attempts; ++i)
      {
        out << "  to the other branch, largest displacement in the critical "
               "shape "
            << amplitude + increment << std::endl;
        along.equations = std::make_shared<const ShapeEquation>(
          run.control->load_rate(), shape, amplitude + increment);
        // from the unperturbed state the loads would do no work on the shape
        // and not be determined
        InitialGuess guess{reached.state, reached.mu};
        LA::Vector   change(shape);
        change *= increment;
        run.equations.update(guess.state, change, NewtonIteration::substituted);
        const Attempt attempt =
          attempt_step(newton, run, along, guess, NewtonIteration::mixed);
        iterations += attempt.result.iterations;
        if (attempt.result.stopped)
          return attempt;
        if (!attempt.result.converged)
          {
            if (++n_cuts > max_cuts)
              return fail(attempt.result.failure.message);
            increment /= 2;
            continue;
          }
        reached = attempt;
        amplitude += increment;
        if (!to_given_loads || reached.mu[0] >= target)
          break;
        // the path of the branch is smooth away from the bifurcation
        if (n_cuts == 0)
          increment = amplitude;
      }
    if (to_given_loads)
      {
        if (reached.mu[0] < target)
          return fail("it does not reach the loads of the next step");
        reached = attempt_step(newton,
                               run,
                               trial,
                               {reached.state, trial.mu},
                               NewtonIteration::mixed);
        iterations += reached.result.iterations;
        if (!reached.result.converged && !reached.result.stopped)
          return fail(reached.result.failure.message);
      }
    else
      trial = along;
    reached.result.iterations = iterations;
    reached.to_branch         = true;
    return reached;
  }
} // namespace Biface
