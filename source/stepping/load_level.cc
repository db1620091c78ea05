// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/stepping/load_level.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    void
    append(std::vector<double> &numbers, const double number)
    {
      numbers.push_back(number);
    }


    void
    append(std::vector<double> &numbers, const Tensor<1, 3> &components)
    {
      numbers.insert(
        numbers.end(), components.begin_raw(), components.end_raw());
    }
  } // namespace


  std::vector<double>
  load_components(const LoadLevel &level)
  {
    std::vector<double> numbers;
    for_each_load([&](const auto &load) { append(numbers, load); }, level);
    return numbers;
  }


  double
  load_fraction(const LoadLevel &start,
                const LoadLevel &reached,
                const LoadLevel &end)
  {
    const std::vector<double> from = load_components(start),
                              now  = load_components(reached),
                              to   = load_components(end);
    // all loads of a stage change in proportion
    for (unsigned int i = 0; i < from.size(); ++i)
      if (to[i] != from[i])
        return (now[i] - from[i]) / (to[i] - from[i]);
    return std::numeric_limits<double>::quiet_NaN();
  }


  LoadLevel
  interpolated_loads(const LoadLevel &first,
                     const LoadLevel &second,
                     const double     position)
  {
    LoadLevel level = first;
    for_each_load(
      [position](auto &load, const auto &from, const auto &to) {
        load = from + position * (to - from);
      },
      level,
      first,
      second);
    return level;
  }


  std::vector<double>
  change_of_factors(const LoadLevel &before, const LoadLevel &after)
  {
    std::vector<double> change;
    for (unsigned int i = 0; i < after.factors.size(); ++i)
      change.push_back(after.factors[i] - before.factors[i]);
    return change;
  }


  double
  relative_change(const LoadLevel &a, const LoadLevel &b)
  {
    const std::vector<double> before = load_components(a),
                              after  = load_components(b);
    double largest                   = 0;
    for (unsigned int i = 0; i < before.size(); ++i)
      // relative to the larger value: a load that begins or ends at 0 has
      // changed wholly
      if (before[i] != after[i])
        largest = std::max(largest,
                           std::abs(after[i] - before[i]) /
                             std::max(std::abs(after[i]), std::abs(before[i])));
    return largest;
  }
} // namespace Biface
