// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_override_h
#define biface_problem_override_h

#include <string>

namespace Biface
{
  /** A setting of an entry from the command line or a study. */
  struct Override
  {
    /** The setting of an option `--set`.
     * @param setting "Section/Entry=value", from the option `--set`. */
    Override(const std::string &setting)
      : setting(setting), source("--set " + setting)
    {}

    Override(const char *setting) : Override(std::string(setting))
    {}

    /** The setting from another source than the command line.
     * @param source its name in error messages. */
    Override(const std::string &setting, const std::string &source)
      : setting(setting), source(source)
    {}

    std::string setting;
    std::string source;
  };


  /** A setting as the text of a parameter file. Throws InputError if it does
   * not have the form "Section/Entry=value" in a single line. */
  std::string
  override_text(const Override &given);
} // namespace Biface

#endif
