// SPDX-License-Identifier: LGPL-2.1-or-later

// Nested dissection of a square grid orders all unknowns of a node one after
// the other, each once, and its factors have at most three quarters of the
// entries of those in the order of the lines.

#include <iostream>
#include <numeric>
#include <set>
#include <vector>

#include <biface/solver/linear/nested_dissection.h>

#include "laplacian.h"
#include <tests.h>

namespace
{
  constexpr int side = 30, n_nodes = side * side, per_node = 3;


  std::vector<int>
  neighbors(const int node)
  {
    std::vector<int> found;
    for (int i = 0; i < n_nodes; ++i)
      if (std::abs(i / side - node / side) <= 1 &&
          std::abs(i % side - node % side) <= 1)
        found.push_back(i);
    return found;
  }


  /** The number of entries of the factors of the graph of the nodes. */
  std::size_t
  n_entries(const std::vector<int> &position)
  {
    std::vector<std::set<int>> later(n_nodes);
    for (int node = 0; node < n_nodes; ++node)
      for (const int other : neighbors(node))
        if (position[other] > position[node])
          later[position[node]].insert(position[other]);
    std::size_t sum = 0;
    for (const std::set<int> &column : later)
      {
        sum += column.size();
        if (!column.empty())
          later[*column.begin()].insert(std::next(column.begin()),
                                        column.end());
      }
    return sum;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int size = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);

  const unsigned int n = n_nodes * per_node;
  IndexSet           owned(n);
  owned.add_range(n_nodes * rank / size * per_node,
                  n_nodes * (rank + 1) / size * per_node);
  DynamicSparsityPattern pattern(n, n, owned);
  for (const auto i : owned)
    for (const int node : neighbors(i / per_node))
      for (int c = 0; c < per_node; ++c)
        pattern.add(i, node * per_node + c);
  LA::SparseMatrix matrix;
  matrix.reinit(owned, pattern, MPI_COMM_WORLD);

  const std::vector<int> positions = nested_dissection(matrix);
  if (rank != 0)
    return 0;
  std::vector<int> of_nodes, all(n), natural(n_nodes);
  bool             together = positions.size() == n;
  for (unsigned int i = 0; i < positions.size(); ++i)
    {
      all[positions[i]]++;
      if (i % per_node == 0)
        of_nodes.push_back(positions[i] / per_node);
      together = together &&
                 positions[i] == of_nodes.back() * per_node + int(i) % per_node;
    }
  std::iota(natural.begin(), natural.end(), 0);
  std::cout << "each once: " << (all == std::vector<int>(n, 1)) << std::endl
            << "unknowns of a node together: " << together << std::endl
            << "fewer entries: "
            << (n_entries(of_nodes) < 0.75 * n_entries(natural)) << std::endl;
}
