// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_restart_numbered_rows_h
#define biface_restart_numbered_rows_h

#include <deal.II/base/table.h>

#include <cstdint>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/active_set.h>
#include <biface/element/modes.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * A table with one row per node or element, identified by a number that does
   * not depend on the number of ranks (Node::number, Cell::number). Each rank
   * has the rows of its own nodes or cells.
   */
  struct NumberedRows
  {
    /** The length of a row, and the number of rows on all ranks. */
    unsigned int  width  = 0;
    std::uint64_t n_rows = 0;

    std::vector<std::uint64_t> numbers;
    /** The values of the rows of this rank, row after row. */
    std::vector<double> values;
  };


  /** A row of the unknowns of each node, in the order of Node::dofs. */
  NumberedRows
  rows_of(const LA::Vector &displacement, const ShellMesh &mesh);

  /** A row of modes per cell. */
  NumberedRows
  rows_of(const std::vector<Modes::Vector> &modes, const ShellMesh &mesh);

  /** A row of one number (1 for active points) per node, or one of as many per
   * cell as there are points in contact, see ContactPoints::per_cell(). */
  NumberedRows
  rows_of(const ActiveSet   &active,
          const ShellMesh   &mesh,
          const unsigned int per_cell);

  /** A row of three components per node, or one of three for each of the points
   * in contact per cell, see ContactPoints::per_cell(). */
  NumberedRows
  rows_of(const std::vector<dealii::Tensor<1, 3>> &values,
          const ShellMesh                         &mesh,
          const unsigned int                       per_cell);

  /** The rows of a table with one row for each node of this rank; their width
   * is 0 if the table is empty. Must be called on all ranks. */
  NumberedRows
  rows_of_nodes(const dealii::Table<2, double> &table, const ShellMesh &mesh);

  /** The rows of a table with one row for each locally owned cell; their width
   * is 0 if the table is empty. Must be called on all ranks. */
  NumberedRows
  rows_of_cells(const dealii::Table<2, double> &table, const ShellMesh &mesh);

  /** The numbers of the nodes that this rank owns. */
  std::vector<std::uint64_t>
  owned_node_numbers(const ShellMesh &mesh);

  std::vector<std::uint64_t>
  node_numbers(const ShellMesh &mesh);

  std::vector<std::uint64_t>
  cell_numbers(const ShellMesh &mesh);

  /** A vector of the locally owned entries, from rows of owned nodes. */
  LA::Vector
  vector_from(const std::vector<double> &values, const ShellMesh &mesh);

  /** The modes of the cells of this rank, from their rows. */
  std::vector<Modes::Vector>
  modes_from(const std::vector<double> &values);

  /** The active set of the points of this rank, from rows of nodes or of
   * cells. */
  ActiveSet
  active_from(const std::vector<double> &values);

  /** The vectors at the points of this rank, from rows of nodes or of cells. */
  std::vector<dealii::Tensor<1, 3>>
  vectors_from(const std::vector<double> &values);

  /** A table from rows, of which there are @p n. */
  dealii::Table<2, double>
  table_from(const std::vector<double> &values, const std::size_t n);
} // namespace Biface

#endif
