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
#include <sstream>

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
  } // namespace


  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator)
  {
    std::string text, reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        reason = read_bytes(file_name, text);
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
        if (line.empty() || line[0] == '#')
          continue;
        result.push_back({name + ", line " + std::to_string(number), line});
        // splitting takes quadratic time
        if (line.size() > 10000)
          throw InputError(result.back().place, line, form);
      }
    return result;
  }


  std::vector<std::vector<double>>
  parse_rows(const std::string &text,
             const std::string &name,
             const std::string &form,
             const unsigned int n_min,
             const unsigned int n_max)
  {
    std::vector<std::vector<double>> rows;
    bool                             header_allowed = true;
    for (const NumberedLine &line : lines_of_csv(text, name, form))
      {
        const std::vector<std::string> cells =
          Utilities::split_string_list(line.text, ',');
        const bool has_row = (cells.size() >= n_min && cells.size() <= n_max);
        if (header_allowed && has_row &&
            std::all_of(cells.begin(), cells.end(), is_name))
          {
            header_allowed = false;
            continue;
          }
        header_allowed = false;
        if (!has_row)
          throw InputError(line.place, line.text, form);
        std::vector<double> row;
        for (const std::string &cell : cells)
          row.push_back(parse_number(line.place, cell, form));
        rows.push_back(row);
      }
    return rows;
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
