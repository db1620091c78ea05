// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
        // the recursion of section 4 of doc/theory.md, exact where the elastic
        // stress changes evenly; expm1 keeps the digits of short steps
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
      // the series, without the difference of two numbers close to 1
      if (x < 0.01)
        return x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6))));
      return 1 + std::expm1(-x) / x;
    }
  } // namespace


  RelaxationAroundLine::RelaxationAroundLine(const Relaxation &relaxation,
                                             const std::vector<TimeStep> &steps)
  {
    // faster by far than any relaxation
    constexpr double fast = 1e-12;

    double turn = 0;
    for (const TimeStep &step : steps)
      turn += step.duration;
    for (const TimeStep &step : steps)
      parts.push_back(step.duration / turn);
    for (const Relaxation::Term &term : relaxation.get_terms())
      {
        Factors factors{term.part, {}, {}, {}, 0};
        double  sum = 0;
        for (const TimeStep &step : steps)
          {
            const double x =
              step.duration /
              (relaxation.factor_of_times(step.temperature) * term.time);
            sum += x;
            factors.remains.push_back(std::exp(-x));
            factors.of_point.push_back(lag(x));
            factors.of_last.push_back(-std::expm1(-x) -
                                      factors.of_point.back());
          }
        // also if it is not a number
        if (!(sum < fast))
          factors.turn = -std::expm1(-sum);
        terms.push_back(std::move(factors));
      }
  }


  std::vector<double>
  RelaxationAroundLine::internal_stresses(
    const std::vector<double> &elastic) const
  {
    const unsigned int  n = parts.size(), n_components = elastic.size() / n;
    const unsigned int  n_numbers = n_components * (terms.size() + 1);
    std::vector<double> numbers(n * n_numbers);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        numbers[k * n_numbers + terms.size() * n_components + c] =
          elastic[k * n_components + c];

    // a row contains the internal variables of each term, and last the elastic
    // stress; the points form a ring around the axle
    const auto before = [n](const unsigned int k) {
      return k > 0 ? k - 1 : n - 1;
    };
    const auto at = [&](const unsigned int k) {
      return &elastic[k * n_components];
    };
    std::vector<double> v(n_components);
    for (unsigned int i = 0; i < terms.size(); ++i)
      {
        const Factors &factors = terms[i];
        const auto     go      = [&](const unsigned int k) {
          // section 10 of doc/theory.md, "Stresses that relax in rolling": a
          // sum of positive terms, without loss of digits at any speed
          const double *now = at(k), *last = at(before(k));
          for (unsigned int c = 0; c < n_components; ++c)
            v[c] = factors.remains[k] * v[c] + factors.of_point[k] * now[c] +
                   factors.of_last[k] * last[c];
        };
        std::fill(v.begin(), v.end(), 0.);
        // the steady state: what a turn from zero adds, divided by the part
        // that a turn forgets, or the mean if a turn takes no time
        if (factors.turn == 0)
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int c = 0; c < n_components; ++c)
              v[c] += parts[k] * (at(k)[c] + at(before(k))[c]) / 2;
        else
          {
            for (unsigned int k = 0; k < n; ++k)
              go(k);
            for (double &component : v)
              component /= factors.turn;
          }
        for (unsigned int k = 0; k < n; ++k)
          {
            go(k);
            // the internal variable is g (S_0 - v)
            double *of_term = &numbers[k * n_numbers + i * n_components];
            for (unsigned int c = 0; c < n_components; ++c)
              of_term[c] = factors.part * (at(k)[c] - v[c]);
          }
      }
    return numbers;
  }
} // namespace Biface
