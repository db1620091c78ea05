// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_read_csv_h
#define biface_tests_read_csv_h

#include <deal.II/base/utilities.h>

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
  std::vector<Row>         rows;
  std::vector<std::string> header;
  std::ifstream            file(name);
  std::string              line;
  while (std::getline(file, line))
    {
      const auto cells = dealii::Utilities::split_string_list(line, ',');
      if (header.empty())
        header = cells;
      else
        {
          Row row;
          for (unsigned int i = 0; i < header.size(); ++i)
            row[header[i]] = cells[i];
          rows.push_back(row);
        }
    }
  return rows;
}

#endif
