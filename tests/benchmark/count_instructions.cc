// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs the program several times for callgrind, which writes a profile of each
// run: see instructions.py. Each '--run' in the arguments starts those of
// another run.

#include <deal.II/base/mpi.h>

#include <iostream>
#include <sstream>

#include <biface/program/program.h>

#include <valgrind/callgrind.h>

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::vector<std::vector<std::string>> runs;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--run")
      runs.emplace_back();
    else
      runs.back().emplace_back(argv[i]);

  // not before: the loader takes longer than the runs
  CALLGRIND_START_INSTRUMENTATION;
  for (const auto &arguments : runs)
    {
      std::ostringstream out;
      CALLGRIND_ZERO_STATS;
      const int code =
        Biface::run_program(arguments, MPI_COMM_WORLD, out, std::cerr);
      CALLGRIND_DUMP_STATS;
      if (code != 0)
        return code;
    }
  return 0;
}
