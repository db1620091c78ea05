// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs the program on a parameter file, see run_file.h, and prints its exit
// code, its error messages, the history without iterations and times, and the
// displacements of the middle surface at named points.

#include "run_file.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto [code, message] = run_file(argv[1], MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  std::cout << "exit code: " << code << '\n' << message;

  std::string   line;
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
