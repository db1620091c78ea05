// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/state/state.h>
#include <biface/stepping/buckling_start.h>

namespace Biface
{
  BucklingStart
  buckling_start(const State                                   &now,
                 const LoadLevel                               &start,
                 const EarlierEquilibrium                      &before_step,
                 const std::function<Loads(const LoadLevel &)> &loads_at)
  {
    const auto              &linearized = now.linearization_point;
    const EarlierEquilibrium from =
      (linearized ? EarlierEquilibrium{*linearized, start} : before_step);
    BucklingStart result{from, loads_at(from.level)};
    // the pressure of a sealed gas may have changed since
    result.loads.pressure = from.level.pressure;
    return result;
  }
} // namespace Biface
