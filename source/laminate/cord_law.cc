// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <biface/laminate/cord_law.h>
#include <biface/laminate/force_curve.h>

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
    // section 4 of doc/theory.md: the stress that slack cords lose, beyond that
    // of the initial state, so that it vanishes with the strain
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


  StretchedCordLaw::StretchedCordLaw(const double modulus,
                                     const double compression,
                                     const double onset,
                                     std::shared_ptr<const ForceCurve> curve,
                                     const double n_per_area)
    : modulus(modulus)
    , compression(compression)
    , onset(onset)
    , curve(std::move(curve))
    , n_per_area(n_per_area)
  {}


  double
  StretchedCordLaw::lowest_modulus() const
  {
    return curve ? std::min(compression,
                            modulus + n_per_area * (curve->lowest_slope() -
                                                    curve->initial_slope()))
                 : compression;
  }


  CordLaw::Response
  StretchedCordLaw::response(const double strain) const
  {
    // the square of a stretch is positive; NaN makes the step fail
    if (!(strain > -0.5))
      {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan, nan};
      }
    const double e = elongation(strain), stretch = 1 + e;
    const double lost = std::min(0., e + onset);
    double W  = modulus * e * e / 2 - (modulus - compression) * lost * lost / 2;
    double P  = modulus * e - (modulus - compression) * lost;
    double dP = lost < 0 ? compression : modulus;
    // what the curve deviates from its tangent at the stretch 1, which is a
    // part of the modulus
    if (curve && e > 0)
      {
        const ForceCurve::Value of_cord = curve->at(stretch);
        const double            slope   = curve->initial_slope();
        W += n_per_area * (of_cord.energy - slope * e * e / 2);
        P += n_per_area * (of_cord.force - slope * e);
        dP += n_per_area * (of_cord.slope - slope);
      }
    // the second Piola-Kirchhoff stress P/lambda and its derivative by the
    // strain, of which lambda has the derivative 1/lambda
    return {W, P / stretch, (dP - P / stretch) / (stretch * stretch)};
  }


  bool
  StretchedCordLaw::is_slack(const double strain) const
  {
    return elongation(strain) < -onset;
  }
} // namespace Biface
