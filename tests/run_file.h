// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_run_file_h
#define biface_tests_run_file_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <biface/program/program.h>

/** @p text with @p by in the place of all @p what. */
inline std::string
replace(std::string text, const std::string &what, const std::string &by)
{
  for (auto at = text.find(what); at != std::string::npos;
       at      = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}


/**
 * Run the program with a command line, and with results in the folder
 * @p results unless it names another.
 *
 * @return its exit code and its error messages.
 */
inline std::pair<int, std::string>
run_command(std::vector<std::string> arguments,
            const std::string       &results,
            const MPI_Comm           communicator)
{
  using namespace dealii;
  arguments.insert(arguments.begin(), {"--output", results});
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    std::filesystem::remove_all(results);
  MPI_Barrier(communicator);

  std::ostringstream out, err;
  const int code = Biface::run_program(arguments, communicator, out, err);

  // all ranks must agree on the exit code
  const auto codes = Utilities::MPI::min_max_avg(code, communicator);
  return {code,
          (codes.min == codes.max ? "" : "the exit codes differ\n") +
            err.str()};
}


/**
 * Run the program on a parameter file, with results in the folder `results`.
 *
 * Comments in the file can change the command line:
 *   # arguments: further arguments, separated by blanks
 *   # file: a parameter file to use instead of this one
 * where {PRM} is the folder of the shipped files, and ~ a blank within an
 * argument.
 *
 * @return its exit code and its error messages, without the names of folders.
 */
inline std::pair<int, std::string>
run_file(std::string file, const MPI_Comm communicator)
{
  std::vector<std::string> arguments;
  std::ifstream            lines(file);
  std::string              line;
  while (std::getline(lines, line))
    {
      line = replace(line, "{PRM}", PRM_DIR);
      if (line.rfind("# arguments: ", 0) == 0)
        {
          std::istringstream stream(line.substr(13));
          std::string        word;
          while (stream >> word)
            arguments.push_back(replace(word, "~", " "));
        }
      else if (line.rfind("# file: ", 0) == 0)
        file = line.substr(8);
    }
  arguments.push_back(file);

  const auto [code, message] = run_command(arguments, "results", communicator);
  const auto folder = std::filesystem::path(file).parent_path().string();
  return {code,
          replace(replace(message, folder + "/", ""),
                  std::string(PRM_DIR) + "/",
                  "")};
}

#endif
