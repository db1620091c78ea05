// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/buckling.h>

namespace Biface
{
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
