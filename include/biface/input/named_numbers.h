// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_named_numbers_h
#define biface_input_named_numbers_h

#include <string>
#include <utility>
#include <vector>

namespace Biface
{
  /** A list of numbers with names. */
  using NamedNumbers = std::vector<std::pair<std::string, double>>;

  /** Read a list of "name: number" with different names, see
   * split_named_list(). */
  NamedNumbers
  parse_named_numbers(const std::string &entry,
                      const std::string &text,
                      const std::string &allowed);
} // namespace Biface

#endif
