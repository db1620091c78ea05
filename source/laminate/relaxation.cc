// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/laminate/relaxation.h>

namespace Biface
{
  double
  Relaxation::Shift::factor(const double temperature) const
  {
    const double T = temperature - reference;
    switch (kind)
      {
        case Kind::none:
          return 1;
        case Kind::WLF:
          return C_2 + T > 0 ? std::pow(10, -C_1 * T / (C_2 + T))
                             : std::numeric_limits<double>::quiet_NaN();
        default:
          return std::exp(activation * (1 / temperature - 1 / reference));
      }
  }


  Relaxation::Step
  Relaxation::step(const TimeStep &time) const
  {
    const double a = time.duration > 0 ? shift.factor(time.temperature) : 1.;
    Step         result{1, {}, {}};
    for (const Term &term : terms)
      {
        const double x       = time.duration / (a * term.time);
        const double remains = std::exp(-x);
        const double grows   = term.part * (x > 0 ? -std::expm1(-x) / x : 1.);
        result.remains.push_back(remains);
        result.grows.push_back(grows);
        result.factor += grows - term.part;
      }
    return result;
  }
} // namespace Biface
