// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <algorithm>

#include <biface/contact/rolling.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  Loads
  StepInTime::over_step(const Loads &end) const
  {
    Loads loads   = end;
    loads.factors = middle.factors;
    // that of a sealed gas follows from the volumes at both ends, see Gas
    if (!loads.sealed_gas)
      loads.pressure = middle.pressure;
    return loads;
  }


  const MovingMass &
  StepInTime::mass_with(const unsigned int factor) const
  {
    const auto found =
      std::find_if(masses.begin(), masses.end(), [&](const MovingMass &mass) {
        return mass.factor == factor;
      });
    AssertThrow(found != masses.end(), dealii::ExcInternalError());
    return *found;
  }


  StepInTime::Spin
  StepInTime::spin(const Loads &end) const
  {
    const double before = (loads_at_start.rolling
                             ? loads_at_start.rolling->angular_velocity
                             : 0.),
                 after  = end.rolling->angular_velocity;
    return {(before + after) / 2, (after - before) / duration};
  }


  LA::Vector
  StepInTime::velocity(const State &end) const
  {
    LA::Vector result = owned_part(end.displacement);
    result -= owned_part(start.displacement);
    result *= 2 / duration;
    result -= owned_part(start.velocity);
    if (of_supports.size() > 0)
      result.add(duration, owned_part(of_supports));
    return result;
  }


  LA::Vector
  StepInTime::acceleration(const State &end) const
  {
    LA::Vector result = velocity(end);
    result -= owned_part(start.velocity);
    result /= duration;
    return result;
  }


  LA::Vector
  extrapolated(const State &state, const double duration)
  {
    LA::Vector result = owned_part(state.displacement);
    result.add(duration, owned_part(state.velocity));
    return result;
  }
} // namespace Biface
