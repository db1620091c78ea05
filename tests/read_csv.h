// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_read_csv_h
#define biface_tests_read_csv_h

#include <deal.II/base/exceptions.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

/** A line of a CSV file by column names. */
using Row = std::map<std::string, std::string>;

/** The lines of a CSV file; empty if it does not exist. */
inline std::vector<Row>
read_csv(const std::string &name)
{
  // also what is after the last comma
  const auto split = [](const std::string &line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    return cells;
  };

  std::vector<Row> rows;
  std::ifstream    file(name);
  std::string      line;
  std::getline(file, line);
  const auto header = split(line);
  while (std::getline(file, line))
    {
      const auto cells = split(line);
      AssertThrow(cells.size() >= header.size(),
                  dealii::ExcDimensionMismatch(cells.size(), header.size()));
      Row &row = rows.emplace_back();
      for (unsigned int i = 0; i < header.size(); ++i)
        row[header[i]] = cells[i];
    }
  return rows;
}

#endif
