// SPDX-License-Identifier: LGPL-2.1-or-later

// SIGTERM and SIGINT end a run within an iteration, with their exit codes and
// complete results, even if no checkpoint was due; a restart continues from the
// last converged step.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  void
  check(const int signal, const std::string &text)
  {
    const auto words = with(coarse_tire, {"Checkpoint/Every steps=0"});
    std::filesystem::remove_all("cut");
    const Ended stopped = run(words, "cut", MPI_COMM_WORLD, text, signal);
    std::cout << stopped.code << '\n' << stopped.err;
    const unsigned int n_steps = read_table("cut/history.csv").size() - 1;
    // other lines begin with "Step" or with two blanks
    const auto table = stopped.out.find("\nstep ");
    check_true("the table is printed",
               table != std::string::npos &&
                 stopped.out.find("\n   " + std::to_string(n_steps) + "  ",
                                  table) != std::string::npos);
    std::cout << n_steps << " steps\n";
    const std::string series = text_of("cut/shell.pvd");
    check_true("the series for ParaView is complete",
               series.find("shell-000" + std::to_string(n_steps)) !=
                 std::string::npos);

    const Ended continued = restart(words, "cut", MPI_COMM_WORLD);
    std::cout << continued.code << '\n' << continued.err;
    check_true(
      "it continues there",
      continued.out.find("continues after step " + std::to_string(n_steps)) !=
        std::string::npos);
    check_small("history", difference("history.csv", "whole", "cut"), 1e-9);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  run(coarse_tire, "whole", MPI_COMM_WORLD);
  check(SIGTERM, "Step 4,");
  // in the first iteration of the step
  check(SIGINT, "approach 10\n    iteration  0");
}
