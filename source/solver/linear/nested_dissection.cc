// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_IntVector.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <biface/base/gather.h>
#include <biface/solver/linear/nested_dissection.h>

#include <metis.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The node of each row of this rank: the number of its first row. */
    std::vector<int>
    find_nodes(const Epetra_CrsMatrix &A)
    {
      std::vector<int> nodes;
      int              last_size = -1, *last = nullptr;
      for (int row = 0; row < A.NumMyRows(); ++row)
        {
          int     size, *columns;
          double *values;
          A.ExtractMyRowView(row, size, values, columns);
          const bool same =
            (size == last_size && std::equal(columns, columns + size, last));
          nodes.push_back(same ? nodes.back() : A.GRID(row));
          last      = columns;
          last_size = size;
        }
      return nodes;
    }


    /** The pairs of different nodes, one after the other, with a common entry
     * in the rows of this rank. */
    std::vector<int>
    find_edges(const Epetra_CrsMatrix &A, const std::vector<int> &nodes)
    {
      Epetra_IntVector of_rows(A.DomainMap());
      std::copy(nodes.begin(), nodes.end(), of_rows.Values());
      Epetra_IntVector of_columns(A.ColMap());
      if (const Epetra_Import *const importer = A.Importer())
        of_columns.Import(of_rows, *importer, Insert);
      else
        of_columns = of_rows;

      std::vector<int> edges;
      for (int row = 0; row < A.NumMyRows(); ++row)
        {
          const int node = nodes[row];
          // the first row of a node stands for all
          if (node != A.GRID(row))
            continue;
          int     size, *columns;
          double *values;
          A.ExtractMyRowView(row, size, values, columns);
          for (int k = 0, last = node; k < size; ++k)
            if (const int other = of_columns[columns[k]];
                other != node && other != last)
              {
                edges.insert(edges.end(), {node, other});
                last = other;
              }
        }
      return edges;
    }


    /** The position of each node of a graph, empty if METIS fails. */
    std::vector<idx_t>
    order_nodes(const std::vector<int> &edges, const unsigned int n_nodes)
    {
      DynamicSparsityPattern graph(n_nodes, n_nodes);
      for (std::size_t k = 0; k < edges.size(); k += 2)
        graph.add(edges[k], edges[k + 1]);
      // METIS wants each edge at both of its nodes
      graph.symmetrize();

      std::vector<idx_t> starts{0}, neighbors;
      for (unsigned int node = 0; node < n_nodes; ++node)
        {
          for (auto entry = graph.begin(node); entry != graph.end(node);
               ++entry)
            neighbors.push_back(entry->column());
          starts.push_back(neighbors.size());
        }
      idx_t              n = n_nodes;
      std::vector<idx_t> order(n_nodes), positions(n_nodes);
      if (METIS_NodeND(&n,
                       starts.data(),
                       neighbors.data(),
                       nullptr,
                       nullptr,
                       order.data(),
                       positions.data()) != METIS_OK)
        return {};
      return positions;
    }
  } // namespace


  std::vector<int>
  nested_dissection(const LA::SparseMatrix &A)
  {
    const MPI_Comm          communicator = A.get_mpi_communicator();
    const Epetra_CrsMatrix &epetra       = A.trilinos_matrix();
    std::vector<int>        nodes        = find_nodes(epetra);
    std::vector<int>        edges =
      gather_numbers(communicator, find_edges(epetra, nodes));
    nodes = gather_numbers(communicator, nodes);
    if (nodes.empty())
      return {};

    // number them without gaps
    int n_nodes = 0;
    for (unsigned int row = 0; row < nodes.size(); ++row)
      nodes[row] = (nodes[row] == int(row) ? n_nodes++ : n_nodes - 1);
    for (int &node : edges)
      node = nodes[node];

    const std::vector<idx_t> of_nodes = order_nodes(edges, n_nodes);
    if (of_nodes.empty())
      return {};
    // where the unknowns of the node at each position start
    std::vector<int> starts(n_nodes + 1, 0);
    for (const int node : nodes)
      ++starts[of_nodes[node] + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<int> positions;
    for (const int node : nodes)
      positions.push_back(starts[of_nodes[node]]++);
    return positions;
  }
} // namespace Biface
