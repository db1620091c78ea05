// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <vector>

#include <biface/model/state/loads.h>
#include <biface/model/state/moving_mass.h>
#include <biface/model/state/state.h>

namespace Biface
{
  double
  MovingMass::change(const Loads &end) const
  {
    return amplitude * factor_at(end.factors, factor) - displacement;
  }


  double
  MovingMass::velocity_at_end(const Loads &end) const
  {
    return 2 * change(end) / duration - velocity;
  }


  double
  MovingMass::acceleration(const Loads &end) const
  {
    return (velocity_at_end(end) - velocity) / duration;
  }


  MovingMass::Resistance
  MovingMass::resistance(const Loads &end) const
  {
    const double dt = duration, of_mass = mass * acceleration(end),
                 of_damper = damping * change(end) / dt,
                 of_spring = stiffness * (displacement + change(end) / 2);
    Resistance result;
    result.value = of_mass + of_damper + of_spring;
    // the acceleration is the difference of two large numbers
    result.magnitude =
      mass * (std::abs(velocity_at_end(end)) + std::abs(velocity)) / dt +
      std::abs(of_damper) + std::abs(of_spring);
    result.derivative = 2 * mass / (dt * dt) + damping / dt + stiffness / 2;
    return result;
  }


  double
  MovingMass::dissipated(const Loads &end) const
  {
    const double way = change(end);
    return damping * way * way / duration;
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
