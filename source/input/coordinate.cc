// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/coordinate.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  Coordinate::Coordinate(const std::string &entry,
                         const std::string &text,
                         const std::string &item,
                         const std::string &allowed)
    : entry(entry), item(item)
  {
    if (text.find("end") != std::string::npos)
      {
        formula_of_end.emplace(entry, text, std::vector<std::string>{"end"});
        return;
      }
    try
      {
        number = parse_number(entry, text, allowed);
      }
    catch (const InputError &)
      {
        // without an operator it is a faulty number, not a formula
        if (text.find_first_of("+-*/^(") == std::string::npos)
          throw;
        number = Formula(entry, text, std::vector<std::string>())({});
      }
  }


  double
  Coordinate::value(const double end) const
  {
    if (!formula_of_end)
      return number;
    if (!std::isfinite(end))
      throw InputError(entry,
                       item,
                       "it must not contain 'end', since this coordinate has "
                       "no last value");
    return (*formula_of_end)({end});
  }
} // namespace Biface
