// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/timer.h>

#include <biface/stepping/load_stepping.h>

namespace Biface
{
  using namespace dealii;

  LoadStepping::Attempt
  LoadStepping::step(const Stage                                  &stage,
                     const std::function<LoadLevel(const double)> &point,
                     double                                       &number,
                     const double                                  size,
                     const PathControl                            *control,
                     Progress                                     &progress,
                     State                                        &state)
  {
    const LoadLevel first = point(number);
    out << "Step " << progress.n_steps + 1 << ", " << stage.name
        << ": pressure " << first.pressure << ", load factor " << first.factor;
    if (stage.contact)
      out << ", approach " << first.travel;
    out << (control ? " at its begin" : "") << std::endl;

    Newton::Path path;
    path.loads = [&](const double number) {
      return loads_at(point(number), stage, progress);
    };
    path.control = control;

    Timer        timer;
    State        trial  = state;
    double       found  = number;
    NewtonResult result = try_step(trial, path, found, size, progress);
    if (result.converged && control != nullptr && found > 1 &&
        stage.control == Stage::Control::arc_length)
      {
        out << "  beyond the loads of the stage: tried again with these"
            << std::endl;
        const unsigned int spent = result.iterations;
        trial                    = state;
        found                    = 1;
        path.control             = nullptr;
        result                   = try_step(trial, path, found, size, progress);
        result.iterations += spent;
      }
    if (!result.converged)
      {
        last_failure = result;
        last_tried   = first;
        if (result.stopped)
          return Attempt::stopped;
        out << "  not converged: " << result.message << std::endl;
        return Attempt::failed;
      }

    report = StepReport();
    if (size > 0)
      {
        progress.predictor.learn(state, trial, size);
        report.instant = {progress.stage, progress.fraction + size};
      }
    state            = trial;
    number           = found;
    progress.reached = point(number);
    ++progress.n_steps;

    report.step              = progress.n_steps;
    report.stage             = stage.name;
    report.in_contact        = stage.contact;
    report.loads             = loads_at(progress.reached, stage, progress);
    report.approach          = (stage.contact ? progress.reached.travel : 0.);
    report.contact           = equations.summarize_contact(state, report.loads);
    report.iterations        = result.iterations;
    report.residuals         = result.residuals;
    report.n_negative_pivots = result.n_negative_pivots;
    report.seconds           = timer.wall_time();
    return Attempt::converged;
  }


  NewtonResult
  LoadStepping::try_step(State              &state,
                         const Newton::Path &path,
                         double             &number,
                         const double        size,
                         const Progress     &progress)
  {
    const State  start       = state;
    const double first_guess = number;
    const bool   zone_given  = size > 0 && predict(size, progress, state);
    NewtonResult result      = newton.solve(
      state, path, number, newton.parameters.iteration, zone_given);
    if (!result.converged && !result.stopped &&
        newton.parameters.iteration == NewtonIteration::mixed)
      {
        out << "  not converged: " << result.message
            << "; tried again with the substituted iteration" << std::endl;
        const unsigned int spent = result.iterations;
        state                    = start;
        number                   = first_guess;
        // the secant may have led astray; the coarser mesh has been there
        if (zone_given)
          predict(size, progress, state);
        result = newton.solve(
          state, path, number, NewtonIteration::substituted, zone_given);
        result.iterations += spent;
      }
    return result;
  }


  bool
  LoadStepping::predict(const double    size,
                        const Progress &progress,
                        State          &state) const
  {
    if (nested != nullptr &&
        nested->predict(equations.mesh,
                        {progress.stage, progress.fraction},
                        {progress.stage, progress.fraction + size},
                        state))
      return true;
    if (parameters.predict)
      progress.predictor.predict(state, size);
    return false;
  }


  LoadLevel
  LoadStepping::point_at(const Stage    &stage,
                         const Progress &progress,
                         const double    fraction) const
  {
    const LoadLevel &begin = progress.begin;
    if (fraction == 1)
      return {stage.pressure, stage.factor, stage.travel};
    return {begin.pressure + fraction * (stage.pressure - begin.pressure),
            begin.factor + fraction * (stage.factor - begin.factor),
            begin.travel + fraction * (stage.travel - begin.travel)};
  }


  Loads
  LoadStepping::loads_at(const LoadLevel &point,
                         const Stage     &stage,
                         const Progress  &progress) const
  {
    Loads loads;
    loads.pressure = point.pressure;
    loads.factor   = point.factor;
    if (stage.contact)
      loads.foundation =
        equations.foundation(*progress.touching_travel + point.travel);
    return loads;
  }
} // namespace Biface
