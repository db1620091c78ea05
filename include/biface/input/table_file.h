// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_input_table_file_h
#define biface_input_table_file_h

#include <deal.II/base/function_lib.h>

#include <memory>
#include <string>
#include <vector>

#include <biface/input/pairs_file.h>

namespace Biface
{
  /** A table of numbers by one argument in a file, which formulas know by its
   * name. */
  struct TableFile
  {
    std::string name;
    PairsFile   file;
  };

  /** Read a list 'name: file', separated by commas; files are not opened.
   * Throws InputError if the list or a name cannot be used.
   * @param argument the name of the argument, which no table has. */
  std::vector<TableFile>
  parse_tables(const std::string &entry,
               const std::string &text,
               const std::string &argument);

  /** The text from which parse_tables() reads these tables. */
  std::string
  print_tables(const std::vector<TableFile> &tables);


  /** A table that is linear between its rows and constant beyond its ends. */
  using InterpolatedTable = std::shared_ptr<
    const dealii::Functions::InterpolatedTensorProductGridData<1>>;

  /** The table in a file that has been read. Throws InputError if it has fewer
   * than two rows or its argument, of the given name, does not increase. */
  InterpolatedTable
  interpolate(const PairsFile &file, const std::string &argument);
} // namespace Biface

#endif
