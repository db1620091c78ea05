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
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/pairs_file.h>
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


    std::string
    lower_case(std::string text)
    {
      for (char &c : text)
        c = std::tolower(static_cast<unsigned char>(c));
      return text;
    }


    /** A name of a column without the unit in brackets behind it, and this
     * unit; lower case. */
    std::pair<std::string, std::string>
    name_and_unit(const std::string &cell)
    {
      const auto open  = cell.find_first_of("[(");
      const auto close = cell.find_first_of("])", open);
      return {lower_case(Utilities::trim(cell.substr(0, open))),
              open == std::string::npos || close == std::string::npos
                ? ""
                : lower_case(
                    Utilities::trim(cell.substr(open + 1, close - open - 1)))};
    }


    /** The unit in a cell of a line of units, which may be in brackets; lower
     * case. */
    std::string
    bare_unit(const std::string &cell)
    {
      const std::string unit = name_and_unit(cell).second;
      return unit.empty() ? lower_case(cell) : unit;
    }


    const std::set<std::string> units_of_length = {
      "m", "mm", "cm", "dm", "km", "um", "in", "inch", "ft"};


    /** Throws InputError if the unit of a column is one of length, but another
     * one than that of the form. */
    void
    check_unit(const NumberedLine &line,
               const std::string  &unit,
               const CsvRowForm   &form)
    {
      const std::string expected = lower_case(form.unit_of_length);
      if (units_of_length.count(expected) == 0 ||
          units_of_length.count(unit) == 0 || unit == expected)
        return;
      throw InputError(line.place,
                       line.text,
                       "lengths must have the unit " + form.unit_of_length +
                         ", which 'Units' names");
    }


    // other names of columns; the first ones that occur are taken
    const std::map<std::string, std::vector<std::string>> other_names = {
      {"radius", {"r", "radial", "radial coordinate", "x"}},
      {"axial coordinate", {"axial", "axis"}}};

    // names of which either may be the axis
    const std::set<std::string> axial_or_radial = {"y", "z"};


    /** The position in the form of each column of a file with these names.
     * Names that are not known are those of the columns that are left, in their
     * order. */
    std::vector<unsigned int>
    order_of_columns(const NumberedLine             &line,
                     const std::vector<std::string> &cells,
                     const CsvRowForm               &form)
    {
      const unsigned int        none = numbers::invalid_unsigned_int;
      const unsigned int        n    = form.columns.size();
      std::vector<unsigned int> order(cells.size(), none);
      std::vector<std::string>  names;
      for (const std::string &cell : cells)
        {
          const auto [name, unit] = name_and_unit(cell);
          check_unit(line, unit, form);
          names.push_back(name);
        }
      std::vector<unsigned int> left;
      for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<std::string> known{form.columns[i]};
          const auto               others = other_names.find(form.columns[i]);
          if (others != other_names.end())
            known.insert(
              known.end(), others->second.begin(), others->second.end());
          unsigned int place = none;
          for (const std::string &name : known)
            for (unsigned int j = 0; j < names.size() && place == none; ++j)
              if (names[j] == name && order[j] == none)
                place = j;
          if (place == none)
            left.push_back(i);
          else
            order[place] = i;
        }
      if (n == cells.size() && n > 0 && form.columns[0] == "radius" &&
          std::set<std::string>(names.begin(), names.end()) == axial_or_radial)
        throw InputError(line.place,
                         line.text,
                         "either of y and z may be the axis: the columns must "
                         "have the names r and z");
      // what is not named is in order
      auto next = left.begin();
      for (unsigned int j = 0; j < order.size(); ++j)
        if (order[j] == none)
          order[j] = (next != left.end() ? *next++ : j);
      const bool is_in_order = std::is_sorted(order.begin(), order.end());
      if (!is_in_order && (n != cells.size() || left.size() > 1))
        throw InputError(line.place, line.text, form.text());
      return order;
    }


    /** A cell without double quotes around it. */
    std::string
    unquoted(const std::string &cell)
    {
      return cell.size() > 1 && cell.front() == '"' && cell.back() == '"'
               ? Utilities::trim(cell.substr(1, cell.size() - 2))
               : cell;
    }


    /** Whether a number with a comma may be one with three decimals as well as
     * one with thousands: 1,250. */
    bool
    may_have_thousands(std::string number)
    {
      if (number[0] == '-' || number[0] == '+')
        number.erase(0, 1);
      const auto comma = number.find(',');
      return comma <= 3 && number[0] != '0' && number.size() == comma + 4 &&
             number.find_first_not_of("0123456789,") == std::string::npos;
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
      CsvRows                   result;
      std::vector<unsigned int> order;
      // the first number with a comma, if none tells what it separates
      std::optional<InputError> doubtful;
      bool                      is_certain = false;
      for (const NumberedLine &line : lines)
        {
          std::vector<std::string> cells =
            split_cells(line.text, style.separator);
          std::transform(cells.begin(), cells.end(), cells.begin(), unquoted);
          const bool has_row =
            (cells.size() >= form.n_min && cells.size() <= form.n_max);
          const bool is_header =
            form.header_allowed && result.n_lines == 0 && has_row &&
            std::all_of(cells.begin(), cells.end(), is_name);
          const bool is_line_of_units =
            !order.empty() && result.n_lines == 1 &&
            std::all_of(cells.begin(), cells.end(), [](const auto &cell) {
              return units_of_length.count(bare_unit(cell)) > 0;
            });
          ++result.n_lines;
          try
            {
              if (is_header)
                {
                  // a message on names is more to the point than that of
                  // another style
                  ++result.n_lines;
                  order = order_of_columns(line, cells, form);
                  --result.n_lines;
                  continue;
                }
              if (is_line_of_units)
                {
                  for (const std::string &cell : cells)
                    check_unit(line, bare_unit(cell), form);
                  continue;
                }
              if (!has_row)
                throw InputError(line.place, line.text, form.text());
              std::vector<double> row;
              for (std::string cell : cells)
                {
                  if (style.decimal_comma && is_decimal_comma(cell))
                    {
                      if (!may_have_thousands(cell))
                        is_certain = true;
                      else if (!doubtful)
                        doubtful.emplace(
                          line.place,
                          cell,
                          "the comma may separate decimals or thousands: "
                          "numbers must have decimal points, or no "
                          "separators of thousands");
                      cell[cell.find(',')] = '.';
                    }
                  // a mixture of points and commas has no meaning
                  else if (style.decimal_comma &&
                           cell.find('.') != std::string::npos)
                    throw InputError(line.place, cell, form.text());
                  row.push_back(parse_number(line.place, cell, form.text()));
                }
              if (!std::is_sorted(order.begin(), order.end()))
                {
                  if (row.size() != order.size())
                    throw InputError(line.place, line.text, form.text());
                  const std::vector<double> cells_of_file = row;
                  for (unsigned int j = 0; j < row.size(); ++j)
                    row[order[j]] = cells_of_file[j];
                }
              result.rows.push_back(row);
            }
          catch (const InputError &error)
            {
              result.error = error;
              return result;
            }
        }
      if (doubtful && !is_certain)
        result.error = doubtful;
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
        if (line.find_first_not_of(",;\t\" ") == std::string::npos ||
            line[0] == '#' || line[0] == '%' ||
            (result.empty() && line.size() <= 5 && line.rfind("sep=", 0) == 0))
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
  parse_rows(const std::string              &text,
             const std::string              &name,
             const std::string              &meaning,
             const unsigned int              n_min,
             const unsigned int              n_max,
             const std::vector<std::string> &columns)
  {
    const CsvRowForm form{meaning, n_min, n_max, true, columns};
    return parse_rows(lines_of_csv(text, name, form.text()), form);
  }


  std::vector<Point<2>>
  parse_pairs(const std::string &text,
              const std::string &name,
              const std::string &meaning,
              const std::string &unit_of_length)
  {
    const CsvRowForm form{"each line must contain two numbers, '" + meaning +
                            "'",
                          2,
                          2,
                          true,
                          split_cells(meaning, ','),
                          unit_of_length};
    std::vector<Point<2>> points;
    for (const auto &row :
         parse_rows(lines_of_csv(text, name, form.text()), form))
      points.emplace_back(row[0], row[1]);
    return points;
  }


  void
  PairsFile::read(const std::string &meaning,
                  const MPI_Comm     communicator,
                  const std::string &unit_of_length)
  {
    pairs =
      parse_pairs(read_file(name, communicator), name, meaning, unit_of_length);
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
