// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/timer.h>

#include <cmath>
#include <cstdio>

#include <biface/base/input_error.h>
#include <biface/base/parameter_tools.h>
#include <biface/solver/load_stepping.h>

namespace Biface
{
  using namespace dealii;

  void
  Stage::add_parameters(ParameterHandler &prm, const unsigned int number)
  {
    name = "stage " + std::to_string(number);
    prm.add_parameter("Name",
                      name,
                      "What the stage is called in results.",
                      Patterns::Anything());
    prm.add_parameter("Pressure",
                      pressure,
                      "Pressure on the inner face at the end of the stage; it "
                      "keeps its initial direction and is counted on the "
                      "surface midway between the faces. Unit: force/area.",
                      Patterns::Double());
    prm.add_parameter("Contact",
                      contact,
                      "Whether the rigid plane of the section 'Contact' is "
                      "there. It first touches the shell as deformed at the "
                      "begin of the first stage with contact.",
                      Patterns::Bool());
    prm.add_parameter("Travel",
                      travel,
                      "How far the plane has moved against its normal at the "
                      "end of the stage, counted from where it first touched. "
                      "Unit: length.",
                      Patterns::Double());
    prm.add_parameter("Load factor",
                      factor,
                      "What the section 'Loads' and prescribed displacements "
                      "of supports are multiplied by at the end of the stage. "
                      "No unit.",
                      Patterns::Double());
    add_choice(prm,
               "Control",
               control,
               {"load", "displacement", "arc length"},
               "What is given in every step: 'load' (equal steps of all "
               "loads), 'displacement' (equal steps of one displacement; the "
               "loads follow on their way to those given, or beyond), or 'arc "
               "length' (steps of the displacements as a whole, which adapt "
               "and pass turning points of the load, until the loads given are "
               "reached; 'Steps' sets the first: 1/Steps of the loads).");
    prm.add_parameter("Control point",
                      control_point,
                      "Name of the point whose displacement (of the middle "
                      "surface) is given.",
                      Patterns::Anything());
    add_choice(prm,
               "Control component",
               control_component,
               {"x", "y", "z"},
               "Component of the displacement that is given.");
    prm.add_parameter("Control value",
                      control_value,
                      "Its value at the end of the stage. Unit: length.",
                      Patterns::Double());
    prm.add_parameter("Steps",
                      n_steps,
                      "Number of steps; see 'Control'.",
                      Patterns::Integer(1));
    add_choice(prm,
               "Strain theory",
               theory,
               {"nonlinear", "linear"},
               "'nonlinear' (finite displacements) or 'linear' (linearized "
               "about the state in which the stage begins, with its stresses; "
               "contact stays one-sided).");
    prm.add_parameter("Begin from prestress",
                      from_prestress,
                      "Whether the stage begins in the undeformed shape with "
                      "the resultants reached so far as initial ones, in "
                      "equilibrium with the loads so far, which are no longer "
                      "listed: 'Pressure' then counts from 0.",
                      Patterns::Bool());
  }


  void
  Stage::check(const std::string &section) const
  {
    if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
      throw InputError(section + "/Name",
                       name,
                       "it must not be empty nor hold a comma or a quotation "
                       "mark");
    if (!std::isfinite(pressure))
      throw InputError(section + "/Pressure",
                       number_to_string(pressure),
                       "it must be a number");
    if (!std::isfinite(travel))
      throw InputError(
        section + "/Travel", number_to_string(travel), "it must be a number");
    if (!std::isfinite(factor))
      throw InputError(section + "/Load factor",
                       number_to_string(factor),
                       "it must be a number");
    if (control != Control::load && theory == StrainTheory::linear)
      throw InputError(section + "/Strain theory",
                       "linear",
                       "a linear stage must have 'Control = load'");
    if (control == Control::displacement && control_point.empty())
      throw InputError(section + "/Control point",
                       control_point,
                       "control by a displacement needs a point");
    if (!contact && travel != 0)
      throw InputError(section + "/Travel",
                       number_to_string(travel),
                       "without 'Contact = true' there is no plane to move");
  }


  void
  LoadStepping::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Maximum cuts",
                      max_cuts,
                      "How often a step that does not converge is halved "
                      "before the run ends.",
                      Patterns::Integer(0, 30));
    prm.add_parameter("Greatest growth",
                      greatest_growth,
                      "How much longer than the first one a step of given arc "
                      "length may become. No unit.",
                      Patterns::Double(1));
  }


  LoadStepping::LoadStepping(const Parameters   &parameters,
                             ShellEquations     &equations,
                             Newton             &newton,
                             ConditionalOStream &out)
    : parameters(parameters), equations(equations), newton(newton), out(out)
  {}


  LoadSteppingResult
  LoadStepping::run(const std::vector<Stage> &stages,
                    State                    &state,
                    const Observer           &observer)
  {
    LoadSteppingResult result;
    for (const Stage &stage : stages)
      {
        result = run_stage(stage, state, observer);
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

    Progress progress;
    progress.begin = reached;
    switch (stage.control)
      {
        case Stage::Control::load:
          return follow_loads(stage, progress, 0, 1, state, observer);
        case Stage::Control::displacement:
          return follow_displacement(stage, progress, state, observer);
        case Stage::Control::arc_length:
          return follow_arc(stage, progress, state, observer);
      }
    Assert(false, ExcInternalError());
    return {};
  }


  LoadSteppingResult
  LoadStepping::follow_loads(const Stage    &stage,
                             Progress       &progress,
                             const double    first,
                             const double    last,
                             State          &state,
                             const Observer &observer)
  {
    for (unsigned int k = 1; k <= stage.n_steps; ++k)
      {
        const double target = first + (last - first) * k / stage.n_steps;
        double       size   = (last - first) / stage.n_steps;
        unsigned int n_cuts = 0;
        progress.fraction   = first + (last - first) * (k - 1) / stage.n_steps;
        while (progress.fraction != target)
          {
            const double left = target - progress.fraction;
            const double next =
              (size < left * (1 - 1e-9) ? progress.fraction + size : target);
            if (step(stage, progress, next, nullptr, state, observer))
              {
                size *= 2;
                n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
              }
            else if (++n_cuts > parameters.max_cuts)
              return failure(stage);
            else
              {
                size = (next - progress.fraction) / 2;
                out << "  the step is cut in half" << std::endl;
              }
          }
      }
    return {};
  }


  LoadSteppingResult
  LoadStepping::follow_displacement(const Stage    &stage,
                                    Progress       &progress,
                                    State          &state,
                                    const Observer &observer)
  {
    const LA::Vector functional =
      equations.discretization.displacement_functional(stage.control_point,
                                                       stage.control_component);

    LA::Vector displacement = equations.discretization.owned_vector();
    displacement            = state.displacement;
    const double begin      = functional * displacement;

    double       done   = 0;
    double       size   = 1. / stage.n_steps;
    unsigned int n_cuts = 0;
    while (done < 1)
      {
        const double next = (done + size < 1 - 1e-9 ? done + size : 1.);
        const DisplacementControl control(
          functional, (next - done) * (stage.control_value - begin));
        if (step(stage, progress, progress.fraction, &control, state, observer))
          {
            done   = next;
            size   = std::min(2 * size, 1. / stage.n_steps);
            n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
          }
        else if (++n_cuts > parameters.max_cuts)
          return failure(stage);
        else
          {
            size /= 2;
            out << "  the step is cut in half" << std::endl;
          }
      }
    return {};
  }


  LoadSteppingResult
  LoadStepping::follow_arc(const Stage    &stage,
                           Progress       &progress,
                           State          &state,
                           const Observer &observer)
  {
    // iterations of a step whose length is right
    constexpr double wanted_iterations = 5;

    LA::Vector before   = equations.discretization.owned_vector();
    LA::Vector previous = equations.discretization.owned_vector();

    // the first step gives the length of the later ones
    before = state.displacement;
    if (!step(stage, progress, 1. / stage.n_steps, nullptr, state, observer))
      return failure(stage);
    previous = state.displacement;
    previous -= before;
    double       length          = previous.l2_norm();
    const double greatest_length = parameters.greatest_growth * length;

    unsigned int n_cuts = 0;
    while (progress.fraction < 1)
      {
        before = state.displacement;
        const ArcLengthControl control(length, previous);
        if (step(stage, progress, progress.fraction, &control, state, observer))
          {
            previous = state.displacement;
            previous -= before;
            const double ease =
              std::sqrt(wanted_iterations / std::max(1u, last_n_iterations));
            length *= std::min(2., std::max(0.5, ease));
            length = std::min(length, greatest_length);
            n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
          }
        else if (++n_cuts > parameters.max_cuts)
          return failure(stage);
        else
          {
            length /= 2;
            out << "  the step is cut in half" << std::endl;
          }
      }
    return {};
  }


  bool
  LoadStepping::step(const Stage       &stage,
                     Progress          &progress,
                     const double       guess,
                     const PathControl *control,
                     State             &state,
                     const Observer    &observer)
  {
    const LoadPoint next = point_at(stage, progress, guess);
    out << "Step " << n_steps + 1 << ", " << stage.name << ": pressure "
        << next.pressure << ", load factor " << next.factor;
    if (stage.contact)
      out << ", approach " << next.travel;
    out << (control ? " at its begin" : "") << std::endl;

    Newton::Path path;
    path.loads = [&](const double fraction) {
      return loads_at(point_at(stage, progress, fraction), stage);
    };
    path.rate.pressure = stage.pressure - progress.begin.pressure;
    path.rate.factor   = stage.factor - progress.begin.factor;
    path.control       = control;

    Timer        timer;
    State        trial    = state;
    double       fraction = guess;
    NewtonResult result   = try_step(trial, path, fraction);
    if (result.converged && control != nullptr && fraction > 1 &&
        stage.control == Stage::Control::arc_length)
      {
        out << "  beyond the loads of the stage: tried again with these"
            << std::endl;
        trial        = state;
        fraction     = 1;
        path.control = nullptr;
        result       = try_step(trial, path, fraction);
      }
    last_n_iterations = result.iterations;
    if (!result.converged)
      {
        last_message = result.message;
        out << "  not converged: " << result.message << std::endl;
        return false;
      }

    state             = trial;
    progress.fraction = fraction;
    reached           = point_at(stage, progress, fraction);
    ++n_steps;

    StepReport report;
    report.step       = n_steps;
    report.stage      = &stage;
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
  LoadStepping::try_step(State              &state,
                         const Newton::Path &path,
                         double             &fraction)
  {
    const State  start       = state;
    const double first_guess = fraction;
    NewtonResult result =
      newton.solve(state, path, fraction, newton.parameters.iteration);
    if (!result.converged &&
        newton.parameters.iteration == NewtonIteration::mixed)
      {
        out << "  not converged: " << result.message
            << "; tried again with the substituted iteration" << std::endl;
        const unsigned int spent = result.iterations;
        state                    = start;
        fraction                 = first_guess;
        result =
          newton.solve(state, path, fraction, NewtonIteration::substituted);
        result.iterations += spent;
      }
    return result;
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
              ") did not converge after " +
              std::to_string(parameters.max_cuts) + " cuts: " + last_message};
  }
} // namespace Biface
