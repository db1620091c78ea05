// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include <biface/base/input_error.h>
#include <biface/base/parameter_tools.h>

namespace Biface
{
  void
  check_positive(const std::string &entry, const double value)
  {
    if (!(std::isfinite(value) && value > 0))
      throw InputError(
        entry, number_to_string(value), "it must be a number above 0");
  }


  void
  check_not_negative(const std::string &entry, const double value)
  {
    if (!(std::isfinite(value) && value >= 0))
      throw InputError(
        entry, number_to_string(value), "it must be a number, 0 or above");
  }


  std::string
  number_to_string(const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.10g", value);
    return text;
  }


  double
  parse_number(const std::string &entry,
               const std::string &text,
               const std::string &allowed)
  {
    const std::string trimmed = dealii::Utilities::trim(text);
    double            value   = 0;
    const auto        result =
      std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), value);
    if (trimmed.empty() || result.ec != std::errc() ||
        result.ptr != trimmed.data() + trimmed.size() || !std::isfinite(value))
      throw InputError(entry, text, allowed);
    return value;
  }
} // namespace Biface
