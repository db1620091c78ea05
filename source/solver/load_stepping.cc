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
    prm.add_parameter(
      "Steps", n_steps, "Number of equal steps.", Patterns::Integer(1));
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

    const LoadPoint begin = reached;
    const auto      point = [&](const double fraction) {
      return LoadPoint{begin.pressure +
                         fraction * (stage.pressure - begin.pressure),
                       begin.travel + fraction * (stage.travel - begin.travel)};
    };

    for (unsigned int k = 1; k <= stage.n_steps; ++k)
      {
        double       done   = (k - 1.) / stage.n_steps;
        const double target = double(k) / stage.n_steps;
        double       size   = target - done;
        unsigned int n_cuts = 0;
        while (done < target)
          {
            const double fraction =
              (done + size < target * (1 - 1e-12) ? done + size : target);
            const LoadPoint next  = point(fraction);
            const Loads     loads = loads_at(next, stage);

            out << "Step " << n_steps + 1 << ", " << stage.name << ": pressure "
                << next.pressure;
            if (stage.contact)
              out << ", approach " << next.travel;
            out << std::endl;

            Timer              timer;
            State              trial  = state;
            const NewtonResult newton = try_step(trial, loads);
            if (newton.converged)
              {
                state   = trial;
                reached = next;
                done    = fraction;
                size *= 2;
                n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
                ++n_steps;

                StepReport report;
                report.step       = n_steps;
                report.stage      = &stage;
                report.loads      = loads;
                report.approach   = (stage.contact ? next.travel : 0.);
                report.contact    = equations.summarize_contact(state, loads);
                report.iterations = newton.iterations;
                report.residuals  = newton.residuals;
                report.seconds    = timer.wall_time();
                observer(report, state);
              }
            else
              {
                out << "  not converged: " << newton.message << std::endl;
                if (++n_cuts > parameters.max_cuts)
                  return {false,
                          "step " + std::to_string(n_steps + 1) + " (" +
                            stage.name + ") did not converge after " +
                            std::to_string(parameters.max_cuts) +
                            " cuts: " + newton.message};
                size = (fraction - done) / 2;
                out << "  the step is cut in half" << std::endl;
              }
          }
      }
    return {};
  }


  NewtonResult
  LoadStepping::try_step(State &state, const Loads &loads)
  {
    const State  start = state;
    NewtonResult result =
      newton.solve(state, loads, newton.parameters.iteration);
    if (!result.converged &&
        newton.parameters.iteration == NewtonIteration::mixed)
      {
        out << "  not converged: " << result.message
            << "; tried again with the substituted iteration" << std::endl;
        const unsigned int spent = result.iterations;
        state                    = start;
        result = newton.solve(state, loads, NewtonIteration::substituted);
        result.iterations += spent;
      }
    return result;
  }


  Loads
  LoadStepping::loads_at(const LoadPoint &point, const Stage &stage) const
  {
    Loads loads;
    loads.pressure = point.pressure;
    if (stage.contact)
      loads.foundation = touching_plane->moved(point.travel);
    return loads;
  }
} // namespace Biface
