// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/restart/numbered_rows.h>

namespace Biface
{
  using namespace dealii;

  NumberedRows
  rows_of(const LA::Vector &displacement, const ShellMesh &mesh)
  {
    // by the numbers of nodes: those of unknowns depend on the partition
    NumberedRows rows;
    rows.width   = mesh.n_dofs_per_node();
    rows.n_rows  = mesh.n_nodes();
    rows.numbers = owned_node_numbers(mesh);
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (const types::global_dof_index dof : node.dofs)
          rows.values.push_back(displacement(dof));
    return rows;
  }


  NumberedRows
  rows_of(const std::vector<Modes::Vector> &modes, const ShellMesh &mesh)
  {
    AssertDimension(modes.size(), mesh.cells.size());
    NumberedRows rows;
    rows.width   = Modes::n;
    rows.n_rows  = mesh.n_elements();
    rows.numbers = cell_numbers(mesh);
    for (const Modes::Vector &mode : modes)
      for (unsigned int i = 0; i < Modes::n; ++i)
        rows.values.push_back(mode[i]);
    return rows;
  }


  namespace
  {
    /** Rows of @p width numbers of each point in contact, which a function
     * adds. */
    template <typename Function>
    NumberedRows
    rows_of_points(const ShellMesh   &mesh,
                   const unsigned int per_cell,
                   const unsigned int width,
                   const Function    &add)
    {
      NumberedRows rows;
      if (per_cell > 0)
        {
          rows.width   = width * per_cell;
          rows.n_rows  = mesh.n_elements();
          rows.numbers = cell_numbers(mesh);
          for (unsigned int point = 0; point < per_cell * mesh.cells.size();
               ++point)
            add(point, rows.values);
          return rows;
        }
      rows.width   = width;
      rows.n_rows  = mesh.n_nodes();
      rows.numbers = owned_node_numbers(mesh);
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].locally_owned)
          add(n, rows.values);
      return rows;
    }
  } // namespace


  NumberedRows
  rows_of(const ActiveSet   &active,
          const ShellMesh   &mesh,
          const unsigned int per_cell)
  {
    return rows_of_points(
      mesh,
      per_cell,
      1,
      [&](const unsigned int point, std::vector<double> &values) {
        values.push_back(active[point]);
      });
  }


  NumberedRows
  rows_of(const std::vector<Tensor<1, 3>> &vectors,
          const ShellMesh                 &mesh,
          const unsigned int               per_cell)
  {
    return rows_of_points(
      mesh,
      per_cell,
      3,
      [&](const unsigned int point, std::vector<double> &values) {
        for (unsigned int i = 0; i < 3; ++i)
          values.push_back(vectors[point][i]);
      });
  }


  namespace
  {
    /** A table without rows has lost its width. */
    unsigned int
    width_on_all_ranks(const Table<2, double> &table, const ShellMesh &mesh)
    {
      return Utilities::MPI::max(static_cast<unsigned int>(table.size(1)),
                                 mesh.communicator);
    }
  } // namespace


  NumberedRows
  rows_of_nodes(const Table<2, double> &table, const ShellMesh &mesh)
  {
    NumberedRows rows;
    rows.width   = width_on_all_ranks(table, mesh);
    rows.n_rows  = mesh.n_nodes();
    rows.numbers = owned_node_numbers(mesh);
    for (unsigned int n = 0; n < table.size(0); ++n)
      if (mesh.nodes[n].locally_owned)
        for (unsigned int i = 0; i < rows.width; ++i)
          rows.values.push_back(table[n][i]);
    return rows;
  }


  NumberedRows
  rows_of_cells(const Table<2, double> &table, const ShellMesh &mesh)
  {
    NumberedRows rows;
    rows.width   = width_on_all_ranks(table, mesh);
    rows.n_rows  = mesh.n_elements();
    rows.numbers = cell_numbers(mesh);
    for (unsigned int c = 0; c < table.size(0); ++c)
      for (unsigned int i = 0; i < rows.width; ++i)
        rows.values.push_back(table[c][i]);
    return rows;
  }


  std::vector<std::uint64_t>
  owned_node_numbers(const ShellMesh &mesh)
  {
    std::vector<std::uint64_t> numbers;
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        numbers.push_back(node.number);
    return numbers;
  }


  std::vector<std::uint64_t>
  node_numbers(const ShellMesh &mesh)
  {
    std::vector<std::uint64_t> numbers;
    for (const Node &node : mesh.nodes)
      numbers.push_back(node.number);
    return numbers;
  }


  std::vector<std::uint64_t>
  cell_numbers(const ShellMesh &mesh)
  {
    std::vector<std::uint64_t> numbers;
    for (const Cell &cell : mesh.cells)
      numbers.push_back(cell.number);
    return numbers;
  }


  LA::Vector
  vector_from(const std::vector<double> &values, const ShellMesh &mesh)
  {
    LA::Vector  vector = mesh.owned_vector();
    std::size_t i      = 0;
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (const types::global_dof_index dof : node.dofs)
          vector(dof) = values.at(i++);
    vector.compress(VectorOperation::insert);
    return vector;
  }


  std::vector<Modes::Vector>
  modes_from(const std::vector<double> &values)
  {
    std::vector<Modes::Vector> modes(values.size() / Modes::n);
    for (std::size_t i = 0; i < values.size(); ++i)
      modes[i / Modes::n][i % Modes::n] = values[i];
    return modes;
  }


  ActiveSet
  active_from(const std::vector<double> &values)
  {
    ActiveSet active;
    for (const double value : values)
      active.push_back(value != 0);
    return active;
  }


  std::vector<Tensor<1, 3>>
  vectors_from(const std::vector<double> &values)
  {
    std::vector<Tensor<1, 3>> vectors(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i)
      vectors[i / 3][i % 3] = values[i];
    return vectors;
  }


  Table<2, double>
  table_from(const std::vector<double> &values, const std::size_t n)
  {
    Table<2, double> table(n, n > 0 ? values.size() / n : 0);
    if (!values.empty())
      table.fill(values.begin());
    return table;
  }
} // namespace Biface
