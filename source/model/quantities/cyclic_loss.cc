// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <biface/model/quantities/cyclic_loss.h>

#include <boost/math/special_functions/zeta.hpp>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** @f$\sum_{n=1}^\infty\cos(nx)/n^3@f$, by its power series. */
    class CosineSum
    {
    public:
      CosineSum()
      {
        // for |x| <= pi, terms decrease by a factor of 4 or more
        for (unsigned int k = 1; k <= n_terms; ++k)
          coefficients[k - 1] = 2 * boost::math::zeta(2. * k) /
                                (2. * k * (2 * k + 1) * (2 * k + 2)) *
                                std::pow(2 * numbers::PI, -2. * k);
      }

      double
      operator()(const double angle) const
      {
        const double x =
          std::abs(std::remainder(angle, 2 * numbers::PI)); // in [0, pi]
        // the second derivative log(2 sin(x/2)) is log(x) and a power series,
        // both integrated twice
        const double square = x * x;
        double       series = 0;
        for (unsigned int k = n_terms; k > 0; --k)
          series = (series + coefficients[k - 1]) * square;
        return boost::math::zeta(3.) +
               (x > 0 ? square * (std::log(x) / 2 - 0.75) : 0.) -
               square * series;
      }

    private:
      static constexpr unsigned int n_terms = 24;
      std::array<double, n_terms>   coefficients;
    };


    /** The first terms of this sum. */
    double
    cosine_sum(const double x, const unsigned int n_terms)
    {
      double sum = 0;
      for (unsigned int n = 1; n <= n_terms; ++n)
        sum += std::cos(n * x) / (double(n) * n * n);
      return sum;
    }
  } // namespace


  CyclicLoss::CyclicLoss(const std::vector<double>        &angles,
                         const std::optional<unsigned int> n_harmonics)
    : Q(angles.size())
  {
    const unsigned int n = angles.size();
    Assert(n >= 3 && std::is_sorted(angles.begin(), angles.end()),
           ExcInternalError());

    // the change of the slope at j depends on the values at j-1, j, j+1
    const auto ahead = [&](const unsigned int j) { return (j + 1) % n; };
    const auto step  = [&](const unsigned int j) {
      return angles[ahead(j)] - angles[j] +
             (ahead(j) == 0 ? 2 * numbers::PI : 0.);
    };
    std::vector<std::array<unsigned int, 3>> at(n);
    std::vector<std::array<double, 3>>       change(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        const unsigned int behind = (j + n - 1) % n;
        at[j]                     = {{behind, j, ahead(j)}};
        change[j]                 = {
                          {1 / step(behind), -1 / step(behind) - 1 / step(j), 1 / step(j)}};
      }

    const CosineSum all;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int k = 0; k < n; ++k)
        {
          const double x = angles[j] - angles[k];
          const double C = (n_harmonics ? cosine_sum(x, *n_harmonics) : all(x));
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              Q(at[j][a], at[k][b]) +=
                change[j][a] * C * change[k][b] / numbers::PI;
        }
  }
} // namespace Biface
