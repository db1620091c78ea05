// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Read a file, and return the error, if any. */
    std::string
    read_bytes(const std::string &file_name, std::string &text)
    {
      // devices may have no end
      constexpr std::size_t limit = 64 * 1024 * 1024;

      std::error_code error;
      if (std::filesystem::is_directory(file_name, error))
        return "cannot be read (it is a directory), but must be a readable file";
      errno = 0;
      const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(
        std::fopen(file_name.c_str(), "rb"), &std::fclose);
      if (file)
        {
          std::vector<char> buffer(1 << 16);
          std::size_t       n;
          while (text.size() <= limit &&
                 (n = std::fread(buffer.data(), 1, buffer.size(), file.get())) >
                   0)
            text.append(buffer.data(), n);
        }
      if (!file || std::ferror(file.get()))
        return std::string("cannot be read (") +
               (errno != 0 ? std::strerror(errno) : "unknown reason") +
               "), but must be a readable file";
      if (text.size() > limit)
        return "exceeds the limit of 64 MiB";
      const auto nul = text.find('\0');
      if (nul != std::string::npos)
        return "has a zero byte in line " +
               std::to_string(
                 1 + std::count(text.begin(), text.begin() + nul, '\n')) +
               ", but must be a text in ASCII or UTF-8";
      return {};
    }


    /** Convert the line ends '\r\n' and '\r' to '\n'. */
    void
    unify_line_ends(std::string &text)
    {
      std::string::size_type n = 0;
      for (std::string::size_type i = 0; i < text.size(); ++i)
        if (text[i] != '\r')
          text[n++] = text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
          text[n++] = '\n';
      text.resize(n);
    }


    /** Whether a cell can be the name of a column; 'nan' and 'inf' are faulty
     * numbers. */
    bool
    is_name(const std::string &cell)
    {
      if (cell.empty() || !std::isalpha(static_cast<unsigned char>(cell[0])))
        return false;
      char *end = nullptr;
      std::strtod(cell.c_str(), &end);
      return *end != '\0';
    }


    /** How the numbers of a CSV file are separated and written. */
    struct CsvStyle
    {
      char separator;
      bool decimal_comma;
    };

    // the first one that all lines have is taken; where several fit, they give
    // the same numbers
    constexpr CsvStyle csv_styles[] = {{',', false},
                                       {';', false},
                                       {'\t', false},
                                       {' ', false},
                                       {';', true},
                                       {'\t', true},
                                       {' ', true}};


    /** The rows of numbers of lines in one style, up to the first line that
     * does not have it. */
    struct CsvRows
    {
      std::vector<std::vector<double>> rows;
      /** What is wrong with this line; none if all lines have the style. */
      std::optional<InputError> error;
      std::size_t               n_lines = 0;
    };


    CsvRows
    rows_in_style(const std::vector<NumberedLine> &lines,
                  const CsvStyle                  &style,
                  const CsvRowForm                &form)
    {
      CsvRows result;
      for (const NumberedLine &line : lines)
        {
          const std::vector<std::string> cells =
            split_cells(line.text, style.separator);
          const bool has_row =
            (cells.size() >= form.n_min && cells.size() <= form.n_max);
          const bool is_header =
            form.header_allowed && result.n_lines == 0 && has_row &&
            std::all_of(cells.begin(), cells.end(), is_name);
          ++result.n_lines;
          if (is_header)
            continue;
          try
            {
              if (!has_row)
                throw InputError(line.place, line.text, form.text());
              std::vector<double> row;
              for (std::string cell : cells)
                {
                  if (style.decimal_comma && is_decimal_comma(cell))
                    cell[cell.find(',')] = '.';
                  // a mixture of points and commas has no meaning
                  else if (style.decimal_comma &&
                           cell.find('.') != std::string::npos)
                    throw InputError(line.place, cell, form.text());
                  row.push_back(parse_number(line.place, cell, form.text()));
                }
              result.rows.push_back(row);
            }
          catch (const InputError &error)
            {
              result.error = error;
              return result;
            }
        }
      return result;
    }
  } // namespace


  std::vector<std::string>
  split_cells(const std::string &line, const char separator)
  {
    if (separator == ' ')
      return split_words(line);
    std::vector<std::string> cells;
    std::istringstream       stream(line);
    for (std::string cell; std::getline(stream, cell, separator);)
      cells.push_back(Utilities::trim(cell));
    return cells;
  }


  bool
  is_decimal_comma(const std::string &number)
  {
    const auto comma = number.find(',');
    return comma != std::string::npos && comma > 0 &&
           comma + 1 < number.size() &&
           std::isdigit(static_cast<unsigned char>(number[comma - 1])) &&
           std::isdigit(static_cast<unsigned char>(number[comma + 1])) &&
           number.find_first_not_of("0123456789+-eE,") == std::string::npos &&
           number.find(',', comma + 1) == std::string::npos;
  }


  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator)
  {
    std::string text, reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        // one rank reads for all: others may see another file or none
        reason = read_bytes(file_name, text);
        // the byte order mark that some programs write before UTF-8
        if (text.rfind("\xEF\xBB\xBF", 0) == 0)
          text.erase(0, 3);
        unify_line_ends(text);
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw InputError("the file " + quoted(file_name, 300) + " " + reason +
                       ".");
    return Utilities::MPI::broadcast(communicator, text);
  }


  std::vector<NumberedLine>
  lines_of_csv(const std::string &text,
               const std::string &name,
               const std::string &form)
  {
    std::vector<NumberedLine> result;
    std::istringstream        lines(text);
    std::string               line;
    for (unsigned int number = 1; std::getline(lines, line); ++number)
      {
        line = Utilities::trim(line);
        if (line.empty() || line[0] == '#' || line[0] == '%')
          continue;
        result.push_back({name + ", line " + std::to_string(number), line});
        // splitting takes quadratic time
        if (line.size() > 10000)
          throw InputError(result.back().place, line, form);
      }
    return result;
  }


  std::string
  CsvRowForm::text() const
  {
    return meaning + (n_max > 1
                        ? ", separated by commas, semicolons, tabs or blanks"
                        : "");
  }


  std::vector<std::vector<double>>
  parse_rows(const std::vector<NumberedLine> &lines, const CsvRowForm &form)
  {
    CsvRows farthest;
    for (const CsvStyle &style : csv_styles)
      {
        CsvRows read = rows_in_style(lines, style, form);
        if (!read.error)
          return read.rows;
        // the style that fits most lines is likely the one that is meant, and
        // its message the one that helps
        if (read.n_lines > farthest.n_lines)
          farthest = std::move(read);
      }
    throw *farthest.error;
  }


  std::vector<std::vector<double>>
  parse_rows(const std::string &text,
             const std::string &name,
             const std::string &meaning,
             const unsigned int n_min,
             const unsigned int n_max)
  {
    const CsvRowForm form{meaning, n_min, n_max, true};
    return parse_rows(lines_of_csv(text, name, form.text()), form);
  }


  std::vector<Point<2>>
  parse_pairs(const std::string &text,
              const std::string &name,
              const std::string &meaning)
  {
    std::vector<Point<2>> points;
    for (const auto &row :
         parse_rows(text,
                    name,
                    "each line must contain two numbers, '" + meaning + "'",
                    2,
                    2))
      points.emplace_back(row[0], row[1]);
    return points;
  }


  void
  PairsFile::read(const std::string &meaning, const MPI_Comm communicator)
  {
    pairs = parse_pairs(read_file(name, communicator), name, meaning);
  }


  std::string
  parse_file_name(const std::string &entry, const std::string &text)
  {
    if (text.empty() || text[0] != '"')
      return text;
    const std::string form =
      "a quoted file name must end with a quote, and each % in it must be "
      "followed by two hexadecimal digits";
    if (text.size() < 2 || text.find('"', 1) != text.size() - 1)
      throw InputError(entry, text, form);
    std::string name;
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
      if (text[i] == '%')
        {
          // %00 would end the name
          const std::string digits = text.substr(i + 1, 2);
          if (digits.size() < 2 ||
              digits.find_first_not_of("0123456789abcdefABCDEF") !=
                std::string::npos ||
              std::stoi(digits, nullptr, 16) == 0)
            throw InputError(entry, text, form);
          name += static_cast<char>(std::stoi(digits, nullptr, 16));
          i += 2;
        }
      else
        name += text[i];
    return name;
  }


  std::string
  print_file_name(const std::string &name)
  {
    // characters that end a value or an item, or structure a list of files
    const auto is_special = [](const char c) {
      return static_cast<unsigned char>(c) < 0x20 ||
             std::strchr("#{}(),;\"%\\", c) != nullptr;
    };
    if (std::none_of(name.begin(), name.end(), is_special) &&
        Utilities::trim(name) == name)
      return name;
    std::string text = "\"";
    for (const char c : name)
      if (is_special(c))
        {
          char code[4];
          std::snprintf(
            code, sizeof(code), "%%%02X", static_cast<unsigned char>(c));
          text += code;
        }
      else
        text += c;
    return text + '"';
  }
} // namespace Biface
