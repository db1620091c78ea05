// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

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
                         const std::vector<std::vector<double>> &samples,
                         const unsigned int                      reference)
    : directory(directory)
    , header(own_columns[0])
    , names_of_outputs(columns.begin() + samples[0].size(), columns.end())
    , reference(reference)
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
    // what follows the outputs begins with the status
    const std::string status = std::string(",") + own_columns[1];
    std::string       result = header;
    if (reference > 0)
      {
        std::string related;
        for (const std::string &name : names_of_outputs)
          related += ',' + name + " / sample " + std::to_string(reference);
        result.insert(result.rfind(status), related);
      }
    result += '\n';
    const std::vector<double> of_reference =
      outputs(reference > 0 ? rows[reference - 1] : "");
    for (const std::string &row : rows)
      if (!row.empty())
        {
          std::string related;
          if (reference > 0)
            {
              const std::vector<double> own = outputs(row);
              for (unsigned int o = 0; o < own.size(); ++o)
                {
                  const double ratio = own[o] / of_reference[o];
                  related += (std::isfinite(ratio) ? csv_number(ratio) : "") +
                             std::string(",");
                }
            }
          // the text of the status is in quotes, as nothing before it
          const auto quote = row.find('"');
          result += row.substr(0, quote) + related + row.substr(quote) + '\n';
        }
    return result;
  }


  std::vector<double>
  StudyTable::outputs(const std::string &row) const
  {
    std::vector<double>            result(names_of_outputs.size(),
                               std::numeric_limits<double>::quiet_NaN());
    const std::vector<std::string> cells =
      dealii::Utilities::split_string_list(row.substr(0, row.find('"')), ',');
    // the number of the sample and the variables come first
    const std::size_t first = 1 + samples[0].size();
    for (unsigned int o = 0; o < result.size(); ++o)
      if (first + o < cells.size() && !cells[first + o].empty())
        result[o] = std::stod(cells[first + o]);
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
