// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/buckling.h>

namespace Biface
{
  Buckling
  buckling_from(const BucklingModes &found,
                const LoadLevel     &start,
                const LoadLevel     &first,
                const LoadLevel     &second)
  {
    const double begin = part_of_loads(start, first, second);
    Buckling     result;
    result.modes     = found.modes;
    result.symmetric = found.symmetric;
    for (const BucklingMode &mode : found.modes)
      result.loads.push_back({begin + mode.position * (1 - begin),
                              loads_on_line(first, second, mode.position)});
    return result;
  }
} // namespace Biface
