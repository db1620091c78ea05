// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/buckling.h>

namespace Biface
{
  BucklingStart
  buckling_start(const InternalForces                          &internal_forces,
                 const LoadLevel                               &start,
                 const EarlierEquilibrium                      &before_step,
                 const std::function<Loads(const LoadLevel &)> &loads_at)
  {
    const auto              &linearized = internal_forces.linearization_point();
    const EarlierEquilibrium from =
      (linearized ? EarlierEquilibrium{*linearized, start} : before_step);
    BucklingStart result{from, loads_at(from.level)};
    // that of a sealed gas was another than it is now
    result.loads.pressure = from.level.pressure;
    return result;
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
    const double begin = part_of_loads(from, reached, second);
    Buckling     result;
    result.modes = found.modes;
    for (const BucklingMode &mode : found.modes)
      result.loads.push_back({begin + mode.position * (1 - begin),
                              loads_on_line(first, second, mode.position)});
    return result;
  }
} // namespace Biface
