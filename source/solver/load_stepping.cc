// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

#include <biface/base/input_error.h>
#include <biface/solver/load_stepping.h>

namespace Biface
{
  using namespace dealii;

  void
  LoadStepping::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Maximum cuts",
                      max_cuts,
                      "How often a step that does not converge is halved "
                      "before the run ends.",
                      Patterns::Integer(0, 30));
    prm.add_parameter("Maximum arc steps",
                      max_arc_steps,
                      "After how many steps of given arc length a stage ends, "
                      "whether its loads were reached or not.",
                      Patterns::Integer(1));
    prm.add_parameter("Greatest growth",
                      greatest_growth,
                      "How much longer than the first one a step of given arc "
                      "length, or one of a stage with 'Adaptive steps', may "
                      "become. No unit.",
                      Patterns::Double(1));
    prm.add_parameter("Predictor",
                      predict,
                      "Whether a step of given loads or a given force begins "
                      "with displacements that go on as in the step before, "
                      "which saves iterations.",
                      Patterns::Bool());
  }


  LoadStepping::LoadStepping(const Parameters      &parameters,
                             ShellEquations        &equations,
                             Newton                &newton,
                             ConditionalOStream    &out,
                             const NestedPredictor *nested)
    : parameters(parameters)
    , equations(equations)
    , newton(newton)
    , out(out)
    , nested(nested)
  {}


  LoadSteppingResult
  LoadStepping::run(const std::vector<Stage> &stages,
                    State                    &state,
                    const Observer           &observer)
  {
    LoadSteppingResult result;
    for (stage_number = 0; stage_number < stages.size(); ++stage_number)
      {
        result = run_stage(stages[stage_number], state, observer);
        if (!result.success)
          break;
      }
    return result;
  }


  LoadSteppingResult
  LoadStepping::run_stage(const Stage    &stage,
                          State          &state,
                          const Observer &observer)
  {
    if (stage.from_prestress)
      {
        equations.take_as_prestress(state);
        reached = LoadPoint();
        touching_plane.reset();
      }
    if (stage.contact && !touching_plane)
      touching_plane = equations.touching_plane(state);
    equations.set_theory(stage.theory, state);

    predictor.reset();
    Progress progress;
    progress.begin = reached;
    if (stage.control == Stage::Control::load)
      return follow_loads(stage, progress, state, observer);
    if (stage.control == Stage::Control::force)
      return follow_force(stage, progress, state, observer);

    // the loads follow: there must be some, and nothing else may move with them
    const std::string what = "the stage '" + stage.name +
                             "' is controlled by a displacement or an arc "
                             "length, but ";
    if (stage.pressure == reached.pressure && stage.factor == reached.factor)
      throw InputError(what + "neither its pressure nor its load factor "
                              "differs from that of the stage before.");
    if (stage.contact && stage.travel != reached.travel)
      throw InputError(what + "its foundation moves, too.");
    if (!equations.discretization.prescribed.empty())
      throw InputError(what + "supports prescribe displacements, too.");

    return stage.control == Stage::Control::displacement
             ? follow_displacement(stage, progress, state, observer)
             : follow_arc(stage, progress, state, observer);
  }


  Loads
  LoadStepping::rate(const Stage &stage, const Progress &progress)
  {
    Loads rate;
    rate.pressure = stage.pressure - progress.begin.pressure;
    rate.factor   = stage.factor - progress.begin.factor;
    return rate;
  }


  bool
  LoadStepping::fraction_step(const Stage       &stage,
                              Progress          &progress,
                              const double       guess,
                              const PathControl *control,
                              State             &state,
                              const Observer    &observer)
  {
    double     fraction = guess;
    const auto point    = [&](const double fraction) {
      return point_at(stage, progress, fraction);
    };
    std::optional<Span> span;
    if (stage.control == Stage::Control::load)
      span = {progress.fraction, guess};
    const bool converged =
      step(stage, point, fraction, span, control, state, observer);
    if (converged)
      progress.fraction = fraction;
    return converged;
  }


  bool
  LoadStepping::step(const Stage                                  &stage,
                     const std::function<LoadPoint(const double)> &point,
                     double                                       &number,
                     const std::optional<Span>                    &span,
                     const PathControl                            *control,
                     State                                        &state,
                     const Observer                               &observer)
  {
    const LoadPoint first = point(number);
    out << "Step " << n_steps + 1 << ", " << stage.name << ": pressure "
        << first.pressure << ", load factor " << first.factor;
    if (stage.contact)
      out << ", approach " << first.travel;
    out << (control ? " at its begin" : "") << std::endl;

    Newton::Path path;
    path.loads = [&](const double number) {
      return loads_at(point(number), stage);
    };
    path.control = control;

    Timer        timer;
    State        trial  = state;
    double       found  = number;
    NewtonResult result = try_step(trial, path, found, span);
    if (result.converged && control != nullptr && found > 1 &&
        stage.control == Stage::Control::arc_length)
      {
        out << "  beyond the loads of the stage: tried again with these"
            << std::endl;
        const unsigned int spent = result.iterations;
        trial                    = state;
        found                    = 1;
        path.control             = nullptr;
        result                   = try_step(trial, path, found, span);
        result.iterations += spent;
      }
    last_n_iterations = result.iterations;
    if (!result.converged)
      {
        last_message = result.message;
        out << "  not converged: " << result.message << std::endl;
        return false;
      }

    if (span)
      predictor.learn(state, trial, span->to - span->from);
    state   = trial;
    number  = found;
    reached = point(number);
    ++n_steps;

    StepReport report;
    report.step = n_steps;
    if (span)
      report.moment = {stage_number, span->to};
    report.stage      = stage.name;
    report.in_contact = stage.contact;
    report.loads      = loads_at(reached, stage);
    report.approach   = (stage.contact ? reached.travel : 0.);
    report.contact    = equations.summarize_contact(state, report.loads);
    report.iterations = result.iterations;
    report.residuals  = result.residuals;
    report.seconds    = timer.wall_time();
    observer(report, state);
    return true;
  }


  NewtonResult
  LoadStepping::try_step(State                     &state,
                         const Newton::Path        &path,
                         double                    &number,
                         const std::optional<Span> &span)
  {
    const State  start       = state;
    const double first_guess = number;
    const bool   zone_given  = span && predict(*span, state);
    NewtonResult result      = newton.solve(
      state, path, number, newton.parameters.iteration, zone_given);
    if (!result.converged &&
        newton.parameters.iteration == NewtonIteration::mixed)
      {
        out << "  not converged: " << result.message
            << "; tried again with the substituted iteration" << std::endl;
        const unsigned int spent = result.iterations;
        state                    = start;
        number                   = first_guess;
        // the secant may have led astray; the coarser mesh has been there
        if (zone_given)
          predict(*span, state);
        result = newton.solve(
          state, path, number, NewtonIteration::substituted, zone_given);
        result.iterations += spent;
      }
    return result;
  }


  bool
  LoadStepping::predict(const Span &span, State &state) const
  {
    if (nested != nullptr && nested->predict(equations.discretization,
                                             {stage_number, span.from},
                                             {stage_number, span.to},
                                             state))
      return true;
    if (parameters.predict)
      predictor.predict(state, span.to - span.from);
    return false;
  }


  LoadStepping::LoadPoint
  LoadStepping::point_at(const Stage    &stage,
                         const Progress &progress,
                         const double    fraction) const
  {
    const LoadPoint &begin = progress.begin;
    if (fraction == 1)
      return {stage.pressure, stage.factor, stage.travel};
    return {begin.pressure + fraction * (stage.pressure - begin.pressure),
            begin.factor + fraction * (stage.factor - begin.factor),
            begin.travel + fraction * (stage.travel - begin.travel)};
  }


  Loads
  LoadStepping::loads_at(const LoadPoint &point, const Stage &stage) const
  {
    Loads loads;
    loads.pressure = point.pressure;
    loads.factor   = point.factor;
    if (stage.contact)
      loads.foundation = touching_plane->moved(point.travel);
    return loads;
  }


  LoadSteppingResult
  LoadStepping::failure(const Stage &stage) const
  {
    return {false,
            "step " + std::to_string(n_steps + 1) + " (" + stage.name +
              ") did not converge, though cut in half " +
              std::to_string(parameters.max_cuts) + " times: " + last_message};
  }
} // namespace Biface
