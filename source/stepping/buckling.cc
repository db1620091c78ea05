// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/state/load_rates.h>
#include <biface/stepping/buckling.h>

namespace Biface
{
  LoadRates
  change_of(const LoadLevel &before, const LoadLevel &after)
  {
    LoadRates change;
    change.pressure         = after.pressure - before.pressure;
    change.factors          = change_of_factors(before, after);
    change.travel           = after.travel - before.travel;
    change.angular_velocity = after.angular_velocity - before.angular_velocity;
    return change;
  }


  Buckling
  buckling_from(const BucklingModes &found,
                const LoadLevel     &start,
                const LoadLevel     &first,
                const LoadLevel     &second,
                const bool           sealed)
  {
    // the pressure of a sealed gas is no load that is given
    LoadLevel from = start, reached = first;
    if (sealed)
      from.pressure = reached.pressure = second.pressure;
    const double begin = load_fraction(from, reached, second);
    Buckling     result;
    result.modes = found.modes;
    // positions are 0 before the last step and 1 after it, factors 0 at the
    // start of the stage and 1 at its end, section 9
    for (const BucklingMode &mode : found.modes)
      result.loads.push_back(
        {begin + mode.position * (1 - begin),
         interpolated_loads(first, second, mode.position)});
    return result;
  }
} // namespace Biface
