// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/stepping/controls/step_size.h>

namespace Biface
{
  void
  StepSize::succeeded(const double growth, const double maximum)
  {
    // cuts are given back one by one, so that a hard part of the path does not
    // use up those of the rest
    value  = std::min(growth * value, maximum);
    n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
  }


  bool
  StepSize::failed(const unsigned int max_cuts)
  {
    if (n_cuts >= max_cuts)
      return false;
    ++n_cuts;
    value /= 2;
    return true;
  }


  double
  step_growth(const double wanted, const unsigned int iterations)
  {
    // the root damps the change, since the iterations of a single step scatter
    return std::sqrt(wanted / std::max(1u, iterations));
  }
} // namespace Biface
