// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/laminate/cord_law.h>

namespace Biface
{
  SlackCordLaw::SlackCordLaw(const double loss,
                             const double onset,
                             const double initial_strain)
    : loss(loss), limit(-onset - initial_strain)
  {}


  CordLaw::Response
  SlackCordLaw::response(const double strain) const
  {
    const double e = std::min(0., strain - limit), e_0 = std::min(0., -limit);
    return {-loss * ((e * e - e_0 * e_0) / 2 - e_0 * strain),
            -loss * (e - e_0),
            e < 0 ? -loss : 0.};
  }


  namespace
  {
    /** The change of length, without cancellation. */
    double
    elongation(const double strain)
    {
      return 2 * strain / (1 + std::sqrt(1 + 2 * strain));
    }
  } // namespace


  CordLaw::Response
  StretchedCordLaw::response(const double strain) const
  {
    if (!(strain > -0.5))
      {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan, nan};
      }
    const double e = elongation(strain), stretch = 1 + e;
    const double lost = std::min(0., e + onset);
    const double P    = modulus * e - (modulus - compression) * lost;
    const double dP   = lost < 0 ? compression : modulus;
    return {modulus * e * e / 2 - (modulus - compression) * lost * lost / 2,
            P / stretch,
            (dP - P / stretch) / (stretch * stretch)};
  }


  bool
  StretchedCordLaw::is_slack(const double strain) const
  {
    return elongation(strain) < -onset;
  }
} // namespace Biface
