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


  namespace
  {
    /** @f$1-(1-e^{-x})/x@f$ */
    double
    lag(const double x)
    {
      if (x < 0.01)
        return x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6))));
      return 1 + std::expm1(-x) / x;
    }
  } // namespace


  std::vector<double>
  Relaxation::around_closed_line(const std::vector<TimeStep> &steps,
                                 const std::vector<double>   &elastic) const
  {
    // slower by far than a turn, what relaxes is the mean
    constexpr double slow = 1e-12;

    const unsigned int  n = steps.size(), n_components = elastic.size() / n;
    const unsigned int  n_numbers = n_components * (n_terms() + 1);
    std::vector<double> numbers(n * n_numbers);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        numbers[k * n_numbers + n_terms() * n_components + c] =
          elastic[k * n_components + c];

    double turn = 0;
    for (const TimeStep &step : steps)
      turn += step.duration;
    for (unsigned int i = 0; i < n_terms(); ++i)
      {
        std::vector<double> remains(n), of_point(n), of_last(n);
        double              sum = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            const double x =
              steps[k].duration /
              (shift.factor(steps[k].temperature) * terms[i].time);
            sum += x;
            remains[k]  = std::exp(-x);
            of_point[k] = lag(x);
            of_last[k]  = -std::expm1(-x) - of_point[k];
          }
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const auto at = [&](const unsigned int k) {
              return elastic[k * n_components + c];
            };
            const auto go = [&](double &v, const unsigned int k) {
              v = remains[k] * v + of_point[k] * at(k) +
                  of_last[k] * at((k + n - 1) % n);
            };
            double v = 0;
            if (sum < slow)
              for (unsigned int k = 0; k < n; ++k)
                v +=
                  steps[k].duration / turn * (at(k) + at((k + n - 1) % n)) / 2;
            else
              {
                for (unsigned int k = 0; k < n; ++k)
                  go(v, k);
                v /= -std::expm1(-sum);
              }
            for (unsigned int k = 0; k < n; ++k)
              {
                go(v, k);
                numbers[k * n_numbers + i * n_components + c] =
                  terms[i].part * (at(k) - v);
              }
          }
      }
    return numbers;
  }
} // namespace Biface
