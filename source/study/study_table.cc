// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <biface/output/csv.h>
#include <biface/problem/design_variable.h>
#include <biface/study/study_table.h>

namespace Biface
{
  namespace
  {
    constexpr const char *row_name         = "sample.csv";
    constexpr const char *directory_prefix = "sample-";
    constexpr const char *ok               = "ok";


    /** A text as a cell of a CSV file. */
    std::string
    csv_text(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        if (c == '"')
          result += "\"\"";
        else
          result += (c == '\n' ? ' ' : c);
      return result + '"';
    }


    /** The lines of a small file; none if it cannot be read. */
    std::vector<std::string>
    lines_of(const std::string &path)
    {
      std::vector<std::string> result;
      std::ifstream            file(path);
      for (std::string line; std::getline(file, line);)
        result.push_back(line);
      return result;
    }
  } // namespace


  StudyTable::StudyTable(const std::string                      &directory,
                         const std::vector<std::string>         &columns,
                         const std::vector<std::vector<double>> &samples)
    : directory(directory)
    , header(own_columns[0])
    , samples(samples)
    , rows(samples.size())
  {
    for (const std::string &column : columns)
      header += ',' + column;
    for (unsigned int i = 1; i < own_columns.size(); ++i)
      header += std::string(",") + own_columns[i];
  }


  std::string
  StudyTable::sample_directory(const unsigned int sample) const
  {
    const unsigned int digits =
      std::max<std::size_t>(4, std::to_string(samples.size()).size());
    return directory + "/" + directory_prefix +
           dealii::Utilities::int_to_string(sample + 1, digits);
  }


  std::string
  StudyTable::row_file(const unsigned int sample) const
  {
    return sample_directory(sample) + "/" + row_name;
  }


  std::string
  StudyTable::row_text(const unsigned int sample, const Results &results) const
  {
    const bool  success = results.failure.empty();
    std::string row     = first_cells(sample);
    for (const double value : results.outputs)
      row += (success && !std::isnan(value) ? csv_number(value) : "") + ',';
    return header + '\n' + row + csv_text(success ? ok : results.failure) +
           ',' + std::to_string(results.n_steps) + ',' +
           std::to_string(results.n_iterations) + ',' +
           csv_number(results.seconds) + '\n';
  }


  std::vector<unsigned int>
  StudyTable::collect()
  {
    std::vector<unsigned int> result;
    for (const unsigned int sample : missing())
      {
        // a row is written as a whole, with the header of its table
        const std::vector<std::string> lines = lines_of(row_file(sample));
        if (lines.size() != 2)
          continue;
        // a row with other columns is foreign
        rows[sample] = (lines[0] == header ? lines[1] : "?");
        result.push_back(sample);
      }
    return result;
  }


  bool
  StudyTable::has_foreign_row() const
  {
    for (unsigned int sample = 0; sample < rows.size(); ++sample)
      if (!rows[sample].empty() &&
          rows[sample].rfind(first_cells(sample), 0) != 0)
        return true;
    return false;
  }


  std::string
  StudyTable::text() const
  {
    std::string result = header + '\n';
    for (const std::string &row : rows)
      if (!row.empty())
        result += row + '\n';
    return result;
  }


  std::vector<unsigned int>
  StudyTable::missing() const
  {
    std::vector<unsigned int> result;
    for (unsigned int sample = 0; sample < rows.size(); ++sample)
      if (rows[sample].empty())
        result.push_back(sample);
    return result;
  }


  unsigned int
  StudyTable::n_ok() const
  {
    const std::string cell = ',' + csv_text(ok) + ',';
    return std::count_if(rows.begin(), rows.end(), [&](const auto &row) {
      return row.find(cell) != std::string::npos;
    });
  }


  std::string
  StudyTable::status(const unsigned int sample) const
  {
    const std::string &row   = rows[sample];
    const auto         first = row.find('"');
    return row.substr(first + 1, row.find_last_of('"') - first - 1);
  }


  std::string
  StudyTable::seconds(const unsigned int sample) const
  {
    return rows[sample].substr(rows[sample].find_last_of(',') + 1);
  }


  void
  StudyTable::remove_rows(const std::string &directory)
  {
    std::error_code error;
    for (const auto &entry :
         std::filesystem::directory_iterator(directory, error))
      if (entry.path().filename().string().rfind(directory_prefix, 0) == 0)
        std::filesystem::remove(entry.path() / row_name, error);
  }


  std::string
  StudyTable::first_cells(const unsigned int sample) const
  {
    std::string result = std::to_string(sample + 1);
    for (const double value : samples[sample])
      // exactly, since a restart compares the texts
      result += ',' + exact_number(value);
    return result + ',';
  }
} // namespace Biface
