// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/stepping/buckling.h>

namespace Biface
{
  std::vector<double>
  numbers_of(const LoadLevel &level)
  {
    return {level.pressure,
            level.factor,
            level.travel,
            level.turn,
            level.slide[0],
            level.slide[1],
            level.slide[2],
            level.wheel_turn};
  }


  double
  part_of_loads(const LoadLevel &start,
                const LoadLevel &reached,
                const LoadLevel &end)
  {
    const std::vector<double> from = numbers_of(start),
                              now = numbers_of(reached), to = numbers_of(end);
    for (unsigned int i = 0; i < from.size(); ++i)
      if (to[i] != from[i])
        return (now[i] - from[i]) / (to[i] - from[i]);
    return std::numeric_limits<double>::quiet_NaN();
  }


  LoadLevel
  loads_on_line(const LoadLevel &first,
                const LoadLevel &second,
                const double     position)
  {
    const auto at = [&](const auto &a, const auto &b) {
      return a + position * (b - a);
    };
    LoadLevel level{at(first.pressure, second.pressure),
                    at(first.factor, second.factor),
                    at(first.travel, second.travel),
                    at(first.slide, second.slide),
                    at(first.turn, second.turn)};
    level.wheel_turn = at(first.wheel_turn, second.wheel_turn);
    return level;
  }


  Buckling
  buckling_from(const std::vector<BucklingMode> &modes,
                const LoadLevel                 &start,
                const LoadLevel                 &first,
                const LoadLevel                 &second)
  {
    const double begin = part_of_loads(start, first, second);
    Buckling     result;
    result.modes = modes;
    for (const BucklingMode &mode : modes)
      result.loads.push_back({begin + mode.position * (1 - begin),
                              loads_on_line(first, second, mode.position)});
    return result;
  }
} // namespace Biface
