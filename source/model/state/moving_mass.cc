// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <vector>

#include <biface/model/state/moving_mass.h>
#include <biface/model/state/state.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  double
  MovingMass::change(const StepInTime &step, const Loads &end) const
  {
    return amplitude * (factor_at(end.factors, factor) -
                        factor_at(step.loads_at_start.factors, factor));
  }


  double
  MovingMass::velocity_at_end(const StepInTime &step, const Loads &end) const
  {
    return 2 * change(step, end) / step.duration - velocity;
  }


  double
  MovingMass::acceleration(const StepInTime &step, const Loads &end) const
  {
    return (velocity_at_end(step, end) - velocity) / step.duration;
  }


  MovingMass::Resistance
  MovingMass::resistance(const StepInTime &step, const Loads &end) const
  {
    const double dt   = step.duration,
                 mean = amplitude *
                        (factor_at(step.loads_at_start.factors, factor) +
                         factor_at(end.factors, factor)) /
                        2,
                 of_mass   = mass * acceleration(step, end),
                 of_damper = damping * change(step, end) / dt,
                 of_spring = stiffness * mean;
    Resistance result;
    result.value = of_mass + of_damper + of_spring;
    // the acceleration is the difference of two large numbers
    result.magnitude =
      mass * (std::abs(velocity_at_end(step, end)) + std::abs(velocity)) / dt +
      std::abs(of_damper) + std::abs(of_spring);
    result.derivative = 2 * mass / (dt * dt) + damping / dt + stiffness / 2;
    return result;
  }


  double
  MovingMass::dissipated(const StepInTime &step, const Loads &end) const
  {
    const double way = change(step, end);
    return damping * way * way / step.duration;
  }


  namespace
  {
    /** The name under which a State contains the motions: velocity and
     * acceleration of each factor. */
    constexpr const char *name_of_motions = "moving masses";
  } // namespace


  MovingMass::Motion
  MovingMass::motion_in(const State &state, const unsigned int factor)
  {
    const auto found = state.terms.find(name_of_motions);
    if (found == state.terms.end() ||
        2 * factor + 1 >= found->second.numbers.size())
      return {};
    const std::vector<double> &numbers = found->second.numbers;
    return {numbers[2 * factor], numbers[2 * factor + 1]};
  }


  void
  MovingMass::set_motion(State             &state,
                         const unsigned int factor,
                         const Motion      &motion)
  {
    std::vector<double> &numbers = state.terms[name_of_motions].numbers;
    if (numbers.size() < 2 * factor + 2)
      numbers.resize(2 * factor + 2);
    numbers[2 * factor]     = motion.velocity;
    numbers[2 * factor + 1] = motion.acceleration;
  }


  void
  MovingMass::bring_to_rest(State &state)
  {
    state.terms.erase(name_of_motions);
  }
} // namespace Biface
