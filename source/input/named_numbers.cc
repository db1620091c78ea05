// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/input/named_numbers.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  NamedNumbers
  parse_named_numbers(const std::string &entry,
                      const std::string &text,
                      const std::string &allowed)
  {
    NamedNumbers numbers;
    for (const auto &[name, number] : split_named_list(entry, text, allowed))
      numbers.emplace_back(name, parse_number(entry, number, allowed));
    return numbers;
  }
} // namespace Biface
