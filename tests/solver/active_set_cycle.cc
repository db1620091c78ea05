// SPDX-License-Identifier: LGPL-2.1-or-later

// A cycle is detected once the same sequence of sets has occurred twice, on all
// ranks alike; a constant set, a set that returns once, and a growing set are
// no cycles.

#include <deal.II/base/mpi.h>

#include <iostream>
#include <string>
#include <vector>

#include <biface/solver/active_set_iteration.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** Sets by their letters: which of the nodes a to e are in contact. The first
   * rank has a to c, the last d and e: one rank alone has all. */
  void
  try_sets(const std::string &what, const std::vector<std::string> &sets)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);

    std::string mine;
    for (const char node : std::string("abcde"))
      if (n_ranks == 1 || (node <= 'c' ? 0 : n_ranks - 1) == rank)
        mine += node;

    ActiveSetCycle cycle(MPI_COMM_WORLD);
    std::string    found = "no cycle";
    for (unsigned int k = 0; k < sets.size(); ++k)
      {
        ActiveSet active;
        for (const char node : mine)
          active.push_back(sets[k].find(node) != std::string::npos);
        if (cycle.closes_with(active))
          {
            std::string toggling;
            for (unsigned int n = 0; n < mine.size(); ++n)
              if (cycle.toggling_nodes()[n])
                toggling += mine[n];
            found = "with set " + std::to_string(k + 1) + ", toggling: ";
            for (const auto &part :
                 Utilities::MPI::all_gather(MPI_COMM_WORLD, toggling))
              found += part;
            break;
          }
      }
    if (rank == 0)
      std::cout << what << ": " << found << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  try_sets("at rest", {"a", "ab", "ab", "ab", "ab", "ab", "ab"});
  try_sets("growing", {"", "a", "ab", "abc", "abcd", "abcde", "abcde"});
  try_sets("back once", {"ab", "abc", "ab", "abc", "abcd", "abcd"});
  try_sets("two sets", {"ab", "abc", "ab", "abc", "ab", "abc"});
  try_sets("two, after others", {"", "abd", "ab", "abc", "ab", "abc", "ab"});
  try_sets("on the last rank only", {"ad", "ae", "ad", "ae", "ad"});
  try_sets("three sets", {"a", "ab", "abe", "a", "ab", "abe", "a"});
  try_sets("four sets", {"a", "b", "c", "d", "a", "b", "c", "d", "a"});
  try_sets("five sets",
           {"a", "b", "c", "d", "e", "a", "b", "c", "d", "e", "a", "b"});
}
