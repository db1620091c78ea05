// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/stepping/load_stepping.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** How much longer the next step may be, by the iterations of the last one
     * and those that are wanted. */
    double
    ease(const double wanted, const unsigned int iterations)
    {
      return std::sqrt(wanted / std::max(1u, iterations));
    }


    /** The next state that must be reached: a multiple of the stage's equal
     * steps, or its end. */
    double
    next_target(const Stage &stage, const double fraction)
    {
      const unsigned int n_targets = (stage.adaptive ? 1 : stage.n_steps);
      const double       k = std::floor(fraction * n_targets + 1e-10) + 1;
      return std::min<double>(k, n_targets) / n_targets;
    }
  } // namespace


  LoadStepping::Attempt
  LoadStepping::step_of_loads(const Stage &stage,
                              Progress    &progress,
                              State       &state)
  {
    // fewer iterations than this are an easy step
    constexpr double many_iterations = 8;

    const double first  = 1. / stage.n_steps;
    const double target = next_target(stage, progress.fraction);
    const double left   = target - progress.fraction;
    const double size   = progress.size.get();
    const double next =
      (size < left * (1 - 1e-9) ? progress.fraction + size : target);
    const Attempt attempt =
      (stage.control == Stage::Control::force
         ? force_step(stage, next, progress, state)
         : fraction_step(stage, next, nullptr, progress, state));
    if (attempt != Attempt::converged)
      return attempt;

    progress.fraction = next;
    if (stage.adaptive)
      progress.size.succeeded(
        std::min(2., std::max(1., ease(many_iterations, report.iterations))),
        parameters.greatest_growth * first);
    else if (next == target)
      progress.size = StepSize(first);
    else
      progress.size.succeeded(2, first);
    return attempt;
  }


  LoadStepping::Attempt
  LoadStepping::force_step(const Stage &stage,
                           const double fraction,
                           Progress    &progress,
                           State       &state)
  {
    // how far the foundation goes beyond touching, to find something to press
    // on
    const double nudge = 0.01 * equations.mesh.thickness();

    const auto point = [&](const double travel) {
      LoadLevel result = point_at(stage, progress, fraction);
      result.travel    = travel;
      return result;
    };
    double travel = progress.reached.travel;
    if (equations.count_active(state) == 0)
      travel += equations.travel_to_touch(
                  state, loads_at(progress.reached, stage, progress)) +
                nudge;
    const ForceControl control(progress.begin_value +
                               fraction * (stage.force - progress.begin_value));
    return step(stage,
                point,
                travel,
                fraction - progress.fraction,
                &control,
                progress,
                state);
  }


  LoadStepping::Attempt
  LoadStepping::step_of_displacement(const Stage &stage,
                                     Progress    &progress,
                                     State       &state)
  {
    const LA::Vector functional = equations.mesh.displacement_functional(
      stage.control_point, stage.control_component);
    const double done = progress.value_fraction;
    const double size = progress.size.get();
    const double next = (done + size < 1 - 1e-9 ? done + size : 1.);
    const DisplacementControl control(
      rate(stage, progress),
      functional,
      (next - done) * (stage.control_value - progress.begin_value));
    const Attempt attempt =
      fraction_step(stage, progress.fraction, &control, progress, state);
    if (attempt == Attempt::converged)
      {
        progress.value_fraction = next;
        progress.size.succeeded(2, 1. / stage.n_steps);
      }
    return attempt;
  }


  LoadStepping::Attempt
  LoadStepping::step_of_arc(const Stage &stage,
                            Progress    &progress,
                            State       &state)
  {
    // iterations of a step whose length is right
    constexpr double wanted_iterations = 5;

    LA::Vector before = equations.mesh.owned_vector();
    before            = state.displacement;

    const bool first = (progress.n_arc_steps == 0);
    Attempt    attempt;
    if (first)
      attempt =
        fraction_step(stage, progress.size.get(), nullptr, progress, state);
    else
      {
        const ArcLengthControl control(
          rate(stage, progress), progress.size.get(), progress.last_change);
        attempt =
          fraction_step(stage, progress.fraction, &control, progress, state);
      }
    if (attempt != Attempt::converged)
      return attempt;

    progress.last_change.reinit(before, true);
    progress.last_change = state.displacement;
    progress.last_change -= before;
    ++progress.n_arc_steps;
    if (first)
      {
        progress.first_arc_length = progress.last_change.l2_norm();
        progress.size             = StepSize(progress.first_arc_length);
      }
    else
      progress.size.succeeded(
        std::min(2., std::max(0.5, ease(wanted_iterations, report.iterations))),
        parameters.greatest_growth * progress.first_arc_length);
    return attempt;
  }
} // namespace Biface
