// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_named_files_h
#define biface_input_named_files_h

#include <string>
#include <vector>

namespace Biface
{
  /** A file that formulas know by a name. */
  struct NamedFile
  {
    std::string name;
    std::string file_name;
  };

  /** Read a list 'name: file', separated by commas; files are not opened.
   * Throws InputError where the list or a name cannot be used.
   * @param taken the names of variables that are not free. */
  std::vector<NamedFile>
  parse_named_files(const std::string              &entry,
                    const std::string              &text,
                    const std::vector<std::string> &taken);

  /** The text from which parse_named_files() reads these files. */
  std::string
  print_named_files(const std::vector<NamedFile> &files);
} // namespace Biface

#endif
