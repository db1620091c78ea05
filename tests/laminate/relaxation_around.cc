// SPDX-License-Identifier: LGPL-2.1-or-later

// A material that flows around a closed line and is strained by |sin(phi)|
// loses the energy of the Fourier series in each turn, with the second order of
// the distance of the points.

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/laminate/relaxation.h>

#include "../tests.h"

using namespace Biface;

namespace
{
  constexpr double E_0 = 3, E_inf = 2, part = 1 - E_inf / E_0;

  /** The energy lost in a turn.
   * @param speed the angular velocity, where the time of relaxation is 1. */
  double
  loss(const double speed, const unsigned int n)
  {
    const Relaxation      relaxation({{1, part}}, {});
    const double          angle = 2 * dealii::numbers::PI / n;
    std::vector<double>   strains, elastic;
    std::vector<TimeStep> steps(n, {angle / speed, 0});
    for (unsigned int k = 0; k < n; ++k)
      {
        strains.push_back(std::abs(std::sin(k * angle)));
        elastic.push_back(E_0 * strains.back());
      }
    const auto numbers =
      RelaxationAroundLine(relaxation, steps).internal_stresses(elastic);
    // what is relaxed of the stress
    const auto relaxed = [&](const unsigned int k) {
      return numbers[2 * k] - part * numbers[2 * k + 1];
    };
    double energy = 0;
    for (unsigned int k = 0; k < n; ++k)
      energy += (relaxed(k) + relaxed((k + 1) % n)) / 2 *
                (strains[(k + 1) % n] - strains[k]);
    return energy;
  }
} // namespace


int
main()
{
  // pi sum k E''(k speed) a_k^2 over the harmonics k = 2, 4, ...
  for (const auto &[speed, energy] : {std::pair{0.1, 0.271837},
                                      std::pair{0.5, 0.614242},
                                      std::pair{2., 0.280721}})
    {
      const double coarse = loss(speed, 256), fine = loss(speed, 512);
      check_small(
        "energy with 64 points", loss(speed, 64) - energy, 0.015, energy);
      check_small("order", (coarse - energy) / (fine - energy) - 4, 0.1);
      check_small(
        "extrapolated energy", (4 * fine - coarse) / 3 - energy, 2e-6, energy);
    }

  // a stress that does not vary is relaxed at any speed
  for (const double speed : {0., 1e-200, 1., 1e12, 1e200})
    {
      const Relaxation relaxation({{1, part}, {100, part}}, {});
      const auto       numbers =
        RelaxationAroundLine(relaxation, {{1 / speed, 0}, {2 / speed, 0}})
          .internal_stresses({5, 5});
      for (const unsigned int i : {0, 1, 3, 4})
        check_small("internal stress", numbers[i], 1e-14, 5);
    }
}
