// SPDX-License-Identifier: LGPL-2.1-or-later

// A smaller 'Number of stages', on the command line or in the file, ends the
// run earlier: the sections of the other stages are ignored, which a note says.

#include <fstream>

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

  std::string       text      = text_of(PRM_DIR "/bias_tire.prm");
  const std::string number    = "set Number of stages = ";
  const auto        place     = text.find(number);
  text[place + number.size()] = '1';
  std::ofstream("fewer.prm") << text;
  const Ended checked =
    run({"--check", "fewer.prm"}, "results", MPI_COMM_WORLD);
  std::cout << checked.code << '\n' << checked.err;
  check_true("a note on the file",
             checked.out.find("The section 'Stage 2' is ignored: 'Number of "
                              "stages' is 1.") != std::string::npos);
}
