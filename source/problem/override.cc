// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <vector>

#include <biface/base/errors.h>
#include <biface/problem/override.h>

namespace Biface
{
  using namespace dealii;

  std::string
  override_text(const Override &given)
  {
    const std::string &setting = given.setting;
    const std::string  option  = given.source.substr(0, given.source.find(' '));
    const std::string  value =
      given.source.substr(std::min(option.size() + 1, given.source.size()));
    const std::string form   = "it must have the form 'Section/Entry=value'";
    const auto        equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError(option, value, form);
    const std::vector<std::string> path =
      Utilities::split_string_list(setting.substr(0, equals), '/');
    if (path.empty() || std::find(path.begin(), path.end(), "") != path.end())
      throw InputError(option, value, form);
    // characters that would end the line or continue it in the next one
    if (setting.find_first_of("\n\r#") != std::string::npos ||
        Utilities::trim(setting).back() == '\\')
      throw InputError(option,
                       value,
                       "it must be a single line without '#' and without a "
                       "backslash at the end");

    std::string text;
    for (unsigned int i = 0; i + 1 < path.size(); ++i)
      text += "subsection " + path[i] + "\n";
    text += "set " + path.back() + " = " + setting.substr(equals + 1) + "\n";
    for (unsigned int i = 0; i + 1 < path.size(); ++i)
      text += "end\n";
    return text;
  }
} // namespace Biface
