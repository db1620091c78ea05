// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/pairs_file.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/laminate/force_curve.h>

// pchip.hpp takes isnan() from math.h
// clang-format off
#include <math.h>
#include <boost/math/interpolators/pchip.hpp>
// clang-format on

namespace Biface
{
  class ForceCurve::Interpolation
    : public boost::math::interpolators::pchip<std::vector<double>>
  {
  public:
    using boost::math::interpolators::pchip<std::vector<double>>::pchip;
  };


  ForceCurve::ForceCurve(const PairsFile &file)
  {
    constexpr unsigned int min_rows = 4;

    const auto refuse = [&](const std::string &why) {
      throw InputError(file.name + ": " + why + ".");
    };
    std::vector<double> forces;
    for (const auto &row : file.pairs)
      {
        if (stretches.empty() && (row[0] != 1 || row[1] != 0))
          refuse("the first row must be the stretch 1 and the force 0, but it "
                 "is " +
                 number_to_string(row[0]) + ", " + number_to_string(row[1]));
        if (!stretches.empty() &&
            !(row[0] > stretches.back() && row[1] > forces.back()))
          refuse("stretches and forces must increase from row to row, but " +
                 number_to_string(stretches.back()) + ", " +
                 number_to_string(forces.back()) + " is followed by " +
                 number_to_string(row[0]) + ", " + number_to_string(row[1]));
        stretches.push_back(row[0]);
        forces.push_back(row[1]);
      }
    if (stretches.size() < min_rows)
      refuse("the curve of a cord needs at least four rows of stretch and "
             "force");

    cubic = std::make_shared<const Interpolation>(
      std::vector<double>(stretches), std::move(forces));
    energies.push_back(0);
    for (unsigned int i = 1; i < stretches.size(); ++i)
      // exact for cubics
      energies.push_back(
        energies.back() +
        (stretches[i] - stretches[i - 1]) / 6 *
          ((*cubic)(stretches[i - 1]) +
           4 * (*cubic)((stretches[i - 1] + stretches[i]) / 2) +
           (*cubic)(stretches[i])));
    if (!(initial_slope() > 0))
      refuse("the force must rise at the stretch 1");
  }


  ForceCurve::Value
  ForceCurve::at(const double stretch) const
  {
    const double last = stretches.back();
    if (!(stretch < last))
      {
        // beyond the last row the curve goes on as a line, its energy as a
        // parabola
        const double slope = cubic->prime(last), force = (*cubic)(last),
                     by = stretch - last;
        return {energies.back() + by * (force + by * slope / 2),
                force + by * slope,
                slope};
      }
    const unsigned int i =
      std::upper_bound(stretches.begin(), stretches.end() - 1, stretch) -
      stretches.begin() - 1;
    // Simpson's rule is exact for the cubic between two rows
    const double force = (*cubic)(stretch);
    return {energies[i] +
              (stretch - stretches[i]) / 6 *
                ((*cubic)(stretches[i]) +
                 4 * (*cubic)((stretches[i] + stretch) / 2) + force),
            force,
            cubic->prime(stretch)};
  }


  double
  ForceCurve::lowest_slope() const
  {
    double lowest = initial_slope();
    for (unsigned int i = 1; i < stretches.size(); ++i)
      for (const double stretch :
           {(stretches[i - 1] + stretches[i]) / 2, stretches[i]})
        lowest = std::min(lowest, at(stretch).slope);
    return lowest;
  }
} // namespace Biface
