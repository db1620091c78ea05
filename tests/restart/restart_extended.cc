// SPDX-License-Identifier: LGPL-2.1-or-later

// A completed run has nothing left to do unless a restart extends it; then it
// ends like a run with the longer stage from the start.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  void
  check(const std::string              &name,
        const std::vector<std::string> &first,
        const std::vector<std::string> &more)
  {
    const std::string no_vtu = "Output/Write VTU=false";
    run(with(with(coarse_tire, {no_vtu}), more), "whole", MPI_COMM_WORLD);

    const auto words = with(with(coarse_tire, {no_vtu}), first);
    run(words, "cut", MPI_COMM_WORLD);
    const Ended again = restart(words, "cut", MPI_COMM_WORLD);
    std::cout << name << ": " << again.code << '\n' << again.err;
    check_true("nothing left",
               again.out.find("Run already complete after") !=
                 std::string::npos);
    const Ended extended = restart(with(words, more), "cut", MPI_COMM_WORLD);
    std::cout << "extended: " << extended.code << '\n' << extended.err;
    // another way has no step to predict from: the iteration ends elsewhere
    // within its tolerance
    const auto whole = read_table("whole/history.csv");
    const auto cut   = read_table("cut/history.csv");
    check_true("the same number of steps", whole.size() == cut.size());
    check_small("force",
                std::stod(whole.back().at(3)) - std::stod(cut.back().at(3)),
                1e-6,
                std::stod(whole.back().at(3)));
    check_small("approach",
                std::stod(whole.back().at(2)) - std::stod(cut.back().at(2)),
                1e-9,
                std::stod(whole.back().at(2)));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check("travel",
        {"Stage 2/Travel=10", "Stage 2/Steps=2"},
        {"Stage 2/Travel=20", "Stage 2/Steps=4"});
  check("force",
        {"Stage 2/Control=foundation force",
         "Stage 2/Travel=0",
         "Stage 2/Force=500",
         "Stage 2/Steps=2"},
        {"Stage 2/Control=foundation force",
         "Stage 2/Travel=0",
         "Stage 2/Force=1500",
         "Stage 2/Steps=6"});
  check("another stage",
        {"Number of stages=2"},
        {"Number of stages=3",
         "Stage 3/Pressure=0.2",
         "Stage 3/Contact=true",
         "Stage 3/Travel=20"});
}
