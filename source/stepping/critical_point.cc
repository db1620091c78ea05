// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/stepping/critical_point.h>

namespace Biface
{
  double
  relative_change(const LoadLevel &a, const LoadLevel &b)
  {
    const std::vector<double> before = numbers_of(a), after = numbers_of(b);
    double                    largest = 0;
    for (unsigned int i = 0; i < before.size(); ++i)
      if (before[i] != after[i])
        largest = std::max(largest,
                           std::abs(after[i] - before[i]) /
                             std::max(std::abs(after[i]), std::abs(before[i])));
    return largest;
  }
} // namespace Biface
