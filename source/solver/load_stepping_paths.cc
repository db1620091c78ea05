// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/solver/load_stepping.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The size of steps, which is halved by failures. */
    class StepSize
    {
    public:
      StepSize(const double first, const double greatest)
        : value(first), greatest(greatest)
      {}

      double
      get() const
      {
        return value;
      }

      void
      succeeded(const double growth)
      {
        value  = std::min(growth * value, greatest);
        n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
      }

      /** @return whether there may be another attempt. */
      bool
      failed(const unsigned int max_cuts, ConditionalOStream &out)
      {
        if (n_cuts == max_cuts)
          return false;
        ++n_cuts;
        value /= 2;
        out << "  the step is cut in half" << std::endl;
        return true;
      }

    private:
      double       value;
      const double greatest;
      unsigned int n_cuts = 0;
    };
  } // namespace


  LoadSteppingResult
  LoadStepping::follow_fractions(
    const Stage                             &stage,
    Progress                                &progress,
    const std::function<bool(const double)> &step_to)
  {
    // fewer iterations than this are an easy step
    constexpr double many_iterations = 8;

    const double       first     = 1. / stage.n_steps;
    const unsigned int n_targets = (stage.adaptive ? 1 : stage.n_steps);
    for (unsigned int k = 1; k <= n_targets; ++k)
      {
        const double target = static_cast<double>(k) / n_targets;
        StepSize     size(
          first, stage.adaptive ? parameters.greatest_growth * first : first);
        while (progress.fraction < target)
          {
            const double left = target - progress.fraction;
            const double next =
              (size.get() < left * (1 - 1e-9) ? progress.fraction + size.get()
                                              : target);
            if (step_to(next))
              {
                progress.fraction = next;
                const double ease =
                  std::sqrt(many_iterations / std::max(1u, last_n_iterations));
                size.succeeded(stage.adaptive ? std::min(2., std::max(1., ease))
                                              : 2.);
              }
            else if (!size.failed(parameters.max_cuts, out))
              return failure(stage);
          }
      }
    return {};
  }


  LoadSteppingResult
  LoadStepping::follow_loads(const Stage    &stage,
                             Progress       &progress,
                             State          &state,
                             const Observer &observer)
  {
    return follow_fractions(stage, progress, [&](const double fraction) {
      return fraction_step(stage, progress, fraction, nullptr, state, observer);
    });
  }


  LoadSteppingResult
  LoadStepping::follow_force(const Stage    &stage,
                             Progress       &progress,
                             State          &state,
                             const Observer &observer)
  {
    // how far the plane goes beyond touching, to find something to press on
    const double nudge = 0.01 * equations.discretization.thickness();

    const double begin =
      equations.contact_force(state, loads_at(reached, stage)).value;
    return follow_fractions(stage, progress, [&](const double fraction) {
      const auto point = [&](const double travel) {
        LoadPoint result = point_at(stage, progress, fraction);
        result.travel    = travel;
        return result;
      };
      double travel = reached.travel;
      if (equations.count_active(state) == 0)
        travel +=
          equations.least_clearance(state, loads_at(reached, stage)) + nudge;
      const ForceControl control(begin + fraction * (stage.force - begin));
      return step(stage,
                  point,
                  travel,
                  Span{progress.fraction, fraction},
                  &control,
                  state,
                  observer);
    });
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

    double   done = 0;
    StepSize size(1. / stage.n_steps, 1. / stage.n_steps);
    while (done < 1)
      {
        const double next =
          (done + size.get() < 1 - 1e-9 ? done + size.get() : 1.);
        const DisplacementControl control(rate(stage, progress),
                                          functional,
                                          (next - done) *
                                            (stage.control_value - begin));
        if (fraction_step(
              stage, progress, progress.fraction, &control, state, observer))
          {
            done = next;
            size.succeeded(2);
          }
        else if (!size.failed(parameters.max_cuts, out))
          return failure(stage);
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

    // the first step is one of the loads, and gives the length of the later
    // ones
    before = state.displacement;
    StepSize first(1. / stage.n_steps, 1. / stage.n_steps);
    while (
      !fraction_step(stage, progress, first.get(), nullptr, state, observer))
      if (!first.failed(parameters.max_cuts, out))
        return failure(stage);
    previous = state.displacement;
    previous -= before;

    StepSize length(previous.l2_norm(),
                    parameters.greatest_growth * previous.l2_norm());
    for (unsigned int n = 1; progress.fraction < 1; ++n)
      {
        if (n >= parameters.max_arc_steps)
          return {false,
                  "the loads of the stage '" + stage.name +
                    "' were not reached in " + std::to_string(n) + " steps"};

        before = state.displacement;
        const ArcLengthControl control(
          rate(stage, progress), length.get(), previous);
        if (fraction_step(
              stage, progress, progress.fraction, &control, state, observer))
          {
            previous = state.displacement;
            previous -= before;
            const double ease =
              std::sqrt(wanted_iterations / std::max(1u, last_n_iterations));
            length.succeeded(std::min(2., std::max(0.5, ease)));
          }
        else if (!length.failed(parameters.max_cuts, out))
          return failure(stage);
      }
    return {};
  }
} // namespace Biface
