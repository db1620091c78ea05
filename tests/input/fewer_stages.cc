// SPDX-License-Identifier: LGPL-2.1-or-later

// A smaller 'Number of stages' on the command line ends the run earlier: the
// sections of the other stages are ignored, which a note says.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ended ended = run(with(coarse_tire, {"Number of stages=1", no_vtu}),
                          "results",
                          MPI_COMM_WORLD);
  std::cout << ended.code << '\n' << ended.err;
  check_true("a note",
             ended.out.find("The section 'Stage 2' is ignored: 'Number of "
                            "stages' is 1.") != std::string::npos);
  const auto table = read_table("results/history.csv");
  check_true("one step", table.size() == 2);
}
