// SPDX-License-Identifier: LGPL-2.1-or-later

// Several moments on one edge add up: thirds of the moment that rolls a strip
// into a quarter of a circle bend it like the whole moment.

#include "../restart.h"
#include "../tests.h"

using namespace dealii;

namespace
{
  double
  deflection(const std::string &moments)
  {
    const Ended ended = run(with({PRM_DIR "/roll_up.prm"},
                                 {"Mesh/Intervals alpha_1=0:12:12",
                                  "Stage 1/Load factor=0.25",
                                  "Stage 1/Steps=1",
                                  "Output/Write VTU=false",
                                  "Loads/Edge moments=" + moments}),
                            "results",
                            MPI_COMM_WORLD);
    std::cout << ended.err;
    const auto table = read_table("results/probes.csv");
    return std::stod(table.back().at(7));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double whole = deflection("alpha_1 max: -48 follower");
  const double parts =
    deflection("alpha_1 max: -16 follower, alpha_1 max: -32 follower");
  check_small("follower", parts - whole, 1e-9, whole);
  const double dead = deflection("alpha_1 max: -8 dead");
  const double dead_parts =
    deflection("alpha_1 max: -3 dead, alpha_1 max: -5 dead");
  check_small("dead", dead_parts - dead, 1e-9, dead);
}
