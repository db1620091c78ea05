// SPDX-License-Identifier: LGPL-2.1-or-later

#include <array>

#include <biface/base/errors.h>
#include <biface/input/named_files.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/table_file.h>

namespace Biface
{
  using namespace dealii;

  std::vector<TableFile>
  parse_tables(const std::string &entry,
               const std::string &text,
               const std::string &argument)
  {
    std::vector<TableFile> tables;
    for (const NamedFile &file : parse_named_files(entry, text, {argument}))
      tables.push_back({file.name, {file.file_name, {}}});
    return tables;
  }


  std::string
  print_tables(const std::vector<TableFile> &tables)
  {
    std::vector<NamedFile> files;
    for (const TableFile &table : tables)
      files.push_back({table.name, table.file.name});
    return print_named_files(files);
  }


  InterpolatedTable
  interpolate(const PairsFile &file, const std::string &argument)
  {
    const auto &pairs = file.pairs;
    if (pairs.size() < 2)
      throw InputError(file.name +
                       ": the table needs at least two rows to interpolate.");

    std::vector<double> arguments;
    Table<1, double>    values(pairs.size());
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        if (i > 0 && !(pairs[i][0] > arguments.back()))
          throw InputError(file.name + ": " + argument +
                           " must increase from row to row, but " +
                           number_to_string(arguments.back()) +
                           " is followed by " + number_to_string(pairs[i][0]) +
                           ".");
        arguments.push_back(pairs[i][0]);
        values(i) = pairs[i][1];
      }
    return std::make_shared<
      const Functions::InterpolatedTensorProductGridData<1>>(
      std::array<std::vector<double>, 1>{{arguments}}, values);
  }
} // namespace Biface
