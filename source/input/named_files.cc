// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/input/named_files.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>

namespace Biface
{
  namespace
  {
    /** Whether a text is one variable of a formula: not a number, not a name
     * that is taken, such as pi, and one word. */
    bool
    is_variable(const std::string &name)
    {
      try
        {
          return Formula("", name).used_names() ==
                 std::vector<std::string>{name};
        }
      catch (const InputError &)
        {
          return false;
        }
    }
  } // namespace


  std::vector<NamedFile>
  parse_named_files(const std::string              &entry,
                    const std::string              &text,
                    const std::vector<std::string> &taken)
  {
    const std::string      form = "each table must have the form 'name: file'";
    std::vector<NamedFile> files;
    for (const std::string &item : split_list(entry, text, ',', 1000))
      {
        const auto named = split_named(entry, item, form);
        if (named.second.empty())
          throw InputError(entry, item, form);
        const std::string &name = named.first;
        if (!is_variable(name) || name[0] == '_' ||
            std::count(taken.begin(), taken.end(), name) > 0 ||
            std::any_of(files.begin(), files.end(), [&](const auto &file) {
              return file.name == name;
            }))
          throw InputError(
            entry,
            name,
            "the name of a table must start with a letter, consist of letters, "
            "digits and '_', and differ from other tables, variables and "
            "constants");
        files.push_back({name, parse_file_name(entry, named.second)});
      }
    return files;
  }


  std::string
  print_named_files(const std::vector<NamedFile> &files)
  {
    std::string text;
    for (const NamedFile &file : files)
      text += (text.empty() ? "" : ", ") + file.name + ": " +
              print_file_name(file.file_name);
    return text;
  }
} // namespace Biface
