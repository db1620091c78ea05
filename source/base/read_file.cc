// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <biface/base/input_error.h>
#include <biface/base/parameter_tools.h>
#include <biface/base/read_file.h>

namespace Biface
{
  using namespace dealii;

  std::string
  read_file(const std::string &file_name, const MPI_Comm communicator)
  {
    std::string text, reason;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        errno = 0;
        std::ifstream file(file_name);
        if (std::filesystem::is_directory(file_name, error))
          reason = "it is a directory";
        else if (!file)
          reason = (errno != 0 ? std::strerror(errno) : "unknown reason");
        else
          text.assign(std::istreambuf_iterator<char>(file), {});
      }
    reason = Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw InputError("the file '" + file_name + "' cannot be read (" +
                       reason + "), but it must exist and be readable.");
    return Utilities::MPI::broadcast(communicator, text);
  }


  std::vector<Point<2>>
  parse_pairs(const std::string &text,
              const std::string &name,
              const std::string &meaning)
  {
    const std::string form =
      "each line must hold two numbers, '" + meaning + "'";

    std::vector<Point<2>> points;
    std::istringstream    lines(text);
    std::string           line;
    bool                  header_allowed = true;
    for (unsigned int number = 1; std::getline(lines, line); ++number)
      {
        line = Utilities::trim(line);
        if (line.empty() || line[0] == '#')
          continue;
        const std::vector<std::string> cells =
          Utilities::split_string_list(line, ',');
        const std::string entry = name + ", line " + std::to_string(number);
        if (header_allowed && cells.size() == 2 && !cells[0].empty() &&
            std::isalpha(static_cast<unsigned char>(cells[0][0])) &&
            cells[0] != "nan" && cells[0] != "inf")
          {
            header_allowed = false;
            continue;
          }
        header_allowed = false;
        if (cells.size() != 2)
          throw InputError(entry, line, form);
        points.emplace_back(parse_number(entry, cells[0], form),
                            parse_number(entry, cells[1], form));
      }
    return points;
  }
} // namespace Biface
