// SPDX-License-Identifier: LGPL-2.1-or-later

// A control by a force that an option chooses leaves out the travel of the
// file, with a note.

#include "../restart.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ended ended =
    run(with(coarse_tire,
             {"Stage 2/Control=foundation force", "Stage 2/Force=100", no_vtu}),
        "results",
        MPI_COMM_WORLD);
  std::cout << ended.code << '\n' << ended.err;
  check_true("a note",
             ended.out.find("The entry 'Stage 2/Travel', 20, is ignored: with "
                            "'Control = foundation force' the travel is "
                            "computed.") != std::string::npos);
  const auto table = read_table("results/history.csv");
  check_small("the force", std::stod(table.back()[3]) / 100 - 1, 1e-6);
  // the note is not repeated by the file of the results
  const Ended again =
    run({"--check", "results/parameters.prm"}, "again", MPI_COMM_WORLD);
  check_true("a file that runs",
             again.code == 0 &&
               again.out.find("is ignored") == std::string::npos);
}
