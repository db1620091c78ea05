// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/stepping/sensitivity_table.h>

namespace Biface
{
  double
  SensitivityTable::logarithmic(const unsigned int entry,
                                const unsigned int output) const
  {
    // a result of 0 has no logarithm
    const double value = outputs[output].value;
    return value == 0
             ? std::numeric_limits<double>::quiet_NaN()
             : derivatives[entry][output] * entries[entry].value / value;
  }
} // namespace Biface
