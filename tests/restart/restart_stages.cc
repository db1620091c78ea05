// SPDX-License-Identifier: LGPL-2.1-or-later

// A run of the first stages by '--stages' that is continued ends like a whole
// run, also where a later stage starts from the end of an earlier one.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                       words = with(coarse_tire,
                          {"Output/Write VTU=false",
                                                 "Number of stages=3",
                                                 "Stage 2/Steps=2",
                                                 "Stage 3/Start from=1",
                                                 "Stage 3/Pressure=0.2",
                                                 "Stage 3/Contact=true",
                                                 "Stage 3/Travel=10"});
  run(words, "whole", MPI_COMM_WORLD);

  const auto stages = [&](const std::string &range, const bool continued) {
    auto options = words;
    options.insert(options.end(), {"--stages", range});
    const Ended ended = (continued ? restart(options, "cut", MPI_COMM_WORLD)
                                   : run(options, "cut", MPI_COMM_WORLD));
    std::cout << range << (continued ? " continued" : "") << ": " << ended.code
              << ", steps " << read_table("cut/history.csv").size() - 1
              << std::endl
              << said(ended);
  };
  stages("1", false);
  stages("3-3", true);
  stages("1-2", true);
  stages("2", true);
  stages("3-3", true);
  const auto whole = read_table("whole/history.csv");
  const auto cut   = read_table("cut/history.csv");
  check_true("the same number of steps", whole.size() == cut.size());
  for (const unsigned int column : {2, 3})
    check_small(whole[0].at(column),
                std::stod(whole.back().at(column)) -
                  std::stod(cut.back().at(column)),
                1e-6,
                std::stod(whole.back().at(column)));
}
