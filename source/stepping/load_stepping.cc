// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/stepping/load_stepping.h>

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
    prm.add_parameter("Maximum growth",
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
                    Progress                 &progress,
                    State                    &state,
                    const Observer           &observer)
  {
    while (true)
      {
        const Stage &stage = stages[progress.stage];
        if (!progress.stage_begun)
          begin_stage(stage, progress, state);
        while (!progress.at_end_of(stage))
          {
            const LoadSteppingResult result = next_step(stage, progress, state);
            if (!result.success)
              return result;
            observer(report, state);
          }
        if (progress.stage + 1 >= stages.size())
          return {};
        ++progress.stage;
        progress.stage_begun = false;
      }
  }


  void
  LoadStepping::begin_stage(const Stage &stage,
                            Progress    &progress,
                            State       &state)
  {
    if (stage.from_prestress)
      {
        equations.take_as_prestress(state);
        progress.reached = LoadLevel();
        progress.touching_travel.reset();
      }
    if (stage.contact && !progress.touching_travel)
      progress.touching_travel = equations.touching_travel(state);
    equations.set_theory(stage.theory, state);

    progress.begin            = progress.reached;
    progress.begin_value      = 0;
    progress.fraction         = 0;
    progress.value_fraction   = 0;
    progress.size             = StepSize(1. / stage.n_steps);
    progress.n_arc_steps      = 0;
    progress.first_arc_length = 0;
    progress.predictor.reset();
    progress.stage_begun = true;
    if (stage.control == Stage::Control::load)
      return;
    if (stage.control == Stage::Control::force)
      {
        progress.begin_value =
          equations
            .contact_force(state, loads_at(progress.reached, stage, progress))
            .value;
        return;
      }

    // the loads follow: there must be some, and nothing else may move with them
    const LoadLevel  &reached = progress.reached;
    const std::string what    = "the stage '" + stage.name +
                             "' is controlled by a displacement or an arc "
                             "length, but ";
    if (stage.pressure == reached.pressure && stage.factor == reached.factor)
      throw InputError(what + "neither its pressure nor its load factor "
                              "differs from that of the stage before.");
    if (stage.contact && stage.travel != reached.travel)
      throw InputError(what + "its foundation moves, too.");
    if (!equations.mesh.prescribed.empty())
      throw InputError(what + "supports prescribe displacements, too.");

    if (stage.control == Stage::Control::displacement)
      {
        LA::Vector displacement = equations.mesh.owned_vector();
        displacement            = state.displacement;
        progress.begin_value    = equations.mesh.displacement_functional(
                                 stage.control_point, stage.control_component) *
                               displacement;
      }
  }


  LoadSteppingResult
  LoadStepping::next_step(const Stage &stage, Progress &progress, State &state)
  {
    const bool by_arc = (stage.control == Stage::Control::arc_length);
    if (by_arc && progress.n_arc_steps > 0 &&
        progress.n_arc_steps >= parameters.max_arc_steps)
      {
        LoadSteppingResult result;
        result.success = false;
        result.cause   = FailureCause::too_many_steps;
        result.message = "the loads of the stage '" + stage.name +
                         "' were not reached in " +
                         std::to_string(progress.n_arc_steps) + " steps";
        result.reached = result.tried = progress.reached;
        result.in_contact             = stage.contact;
        return result;
      }

    // attempts that come to nothing leave no trace
    const StepSize first_size = progress.size;
    while (true)
      {
        const Attempt attempt = by_arc ? step_of_arc(stage, progress, state)
                                : stage.control == Stage::Control::displacement
                                  ? step_of_displacement(stage, progress, state)
                                  : step_of_loads(stage, progress, state);
        if (attempt == Attempt::converged)
          return {};
        if (attempt == Attempt::failed &&
            progress.size.failed(parameters.max_cuts, out))
          continue;

        progress.size = first_size;
        LoadSteppingResult result;
        result.success    = false;
        result.stopped    = (attempt == Attempt::stopped);
        result.cause      = last_failure.cause;
        result.in_contact = stage.contact;
        result.reached    = progress.reached;
        result.tried      = last_tried;
        result.message =
          (result.stopped
             ? last_failure.message
             : "step " + std::to_string(progress.n_steps + 1) + " (" +
                 stage.name + ") did not converge, though cut in half " +
                 std::to_string(parameters.max_cuts) +
                 (parameters.max_cuts == 1 ? " time: " : " times: ") +
                 last_failure.message);
        return result;
      }
  }


  Loads
  LoadStepping::rate(const Stage &stage, const Progress &progress)
  {
    Loads rate;
    rate.pressure = stage.pressure - progress.begin.pressure;
    rate.factor   = stage.factor - progress.begin.factor;
    return rate;
  }


  LoadStepping::Attempt
  LoadStepping::fraction_step(const Stage       &stage,
                              const double       guess,
                              const PathControl *control,
                              Progress          &progress,
                              State             &state)
  {
    double     fraction = guess;
    const auto point    = [&](const double fraction) {
      return point_at(stage, progress, fraction);
    };
    const double size =
      (stage.control == Stage::Control::load ? guess - progress.fraction : 0.);
    const Attempt attempt =
      step(stage, point, fraction, size, control, progress, state);
    if (attempt == Attempt::converged)
      progress.fraction = fraction;
    return attempt;
  }
} // namespace Biface
