// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs the program on a parameter file, and prints its exit code, its error
// messages, the history without iterations and times, and the displacements of
// the middle surface at named points.
//
// Comments in the parameter file can change the command line:
//   # arguments: further arguments, separated by blanks
//   # file: a parameter file to use instead of this one
// where {PRM} is the folder of the shipped files.

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <biface/program/program.h>

using namespace dealii;

namespace
{
  std::string
  replace(std::string text, const std::string &what, const std::string &by)
  {
    for (auto at = text.find(what); at != std::string::npos;
         at      = text.find(what, at + by.size()))
      text.replace(at, what.size(), by);
    return text;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::string              file = argv[1];
  std::vector<std::string> words{"biface", "--output", "results"};
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
            words.push_back(replace(word, "~", " "));
        }
      else if (line.rfind("# file: ", 0) == 0)
        file = line.substr(8);
    }
  words.push_back(file);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all("results");
  MPI_Barrier(MPI_COMM_WORLD);

  std::vector<char *> arguments;
  for (std::string &word : words)
    arguments.push_back(&word[0]);
  arguments.push_back(nullptr);

  std::ostringstream out, err;
  const int          code = Biface::run_program(
    words.size(), arguments.data(), MPI_COMM_WORLD, out, err);

  // all ranks must agree on the exit code
  const auto codes = Utilities::MPI::min_max_avg(code, MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  if (codes.min != codes.max)
    std::cout << "the exit codes differ" << std::endl;
  const auto folder = std::filesystem::path(file).parent_path().string();
  std::cout << "exit code: " << code << '\n'
            << replace(replace(err.str(), folder + "/", ""),
                       std::string(PRM_DIR) + "/",
                       "");

  std::ifstream history("results/history.csv");
  if (code != Biface::wrong_input)
    while (std::getline(history, line))
      {
        const auto columns = Utilities::split_string_list(line, ',');
        for (unsigned int i = 0; i < 6; ++i)
          std::cout << columns[i] << ' ';
        // pressures are small numbers for numdiff's absolute tolerance
        if (columns[0] == "step")
          std::cout << "1000*max_pressure" << std::endl;
        else
          std::cout << 1000 * std::stod(columns[6]) << std::endl;
      }

  std::ifstream probes("results/probes.csv");
  if (code != Biface::wrong_input)
    while (std::getline(probes, line))
      {
        const auto columns = Utilities::split_string_list(line, ',');
        if (columns[4] == "middle")
          std::cout << columns[3] << " at load factor " << columns[2] << ": "
                    << columns[5] << ' ' << columns[6] << ' ' << columns[7]
                    << std::endl;
      }
  return 0;
}
