// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

#include <biface/model/equations/tangent_matrix.h>

namespace Biface
{
  using namespace dealii;

  TangentMatrix::TangentMatrix(
    const ShellMesh                        &mesh,
    const AffineConstraints<double>        &constraints,
    const std::vector<ForceTerm::Coupling> &couplings,
    const std::vector<const Cell *>        &elements)
    : mesh(mesh)
    , constraints(constraints)
    , fast_cell(mesh.cells.size(), numbers::invalid_unsigned_int)
    , scratch_matrix(4 * mesh.n_dofs_per_node(), 4 * mesh.n_dofs_per_node())
    , scratch_vector(4 * mesh.n_dofs_per_node())
    , scratch_dofs(4 * mesh.n_dofs_per_node())
  {
    // deal.II counts the rows of a rank without any as more than an int holds
    const unsigned int n_per_row =
      (mesh.locally_owned.is_empty() ? 0 : 9 * mesh.n_dofs_per_node());
    TrilinosWrappers::SparsityPattern pattern(mesh.locally_owned,
                                              mesh.locally_owned,
                                              mesh.locally_relevant,
                                              mesh.communicator,
                                              n_per_row);
    DoFTools::make_sparsity_pattern(
      mesh.get_dof_handler(),
      pattern,
      constraints,
      false,
      Utilities::MPI::this_mpi_process(mesh.communicator));
    for (const ForceTerm::Coupling &coupling : couplings)
      {
        for (const auto row : coupling.rows)
          pattern.add_entries(
            row, coupling.columns.begin(), coupling.columns.end());
        coupled.insert(coupling.nodes);
      }
    for (const Cell *element : elements)
      constraints.add_entries_local_to_global(element->dofs, pattern, false);
    pattern.compress();
    matrix.reinit(pattern);

    const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
    int                    *row_starts;
    int                    *columns;
    if (epetra.ExtractCrsDataPointers(row_starts, columns, values) != 0)
      return; // not stored contiguously: no fast path

    const unsigned int n_of_node = mesh.n_dofs_per_node();
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        if (!cell.is_wall)
          {
            // a layer has the unknowns of the wall before it
            fast_cell[c] = fast_cell[c - 1];
            continue;
          }
        // rows of unknowns that are free and owned go directly into the arrays
        // of the matrix; all others need constraints or an exchange between
        // ranks
        bool fast = true;
        for (const auto dof : cell.dofs)
          fast = fast && mesh.locally_owned.is_element(dof) &&
                 !constraints.is_constrained(dof);

        Places cell_places(fast ? cell.dofs.size() : 0);
        for (unsigned int i = 0; fast && i < cell.dofs.size(); ++i)
          {
            const int row   = epetra.LRID(static_cast<int>(cell.dofs[i]));
            int      *begin = columns + row_starts[row];
            int      *end   = columns + row_starts[row + 1];
            for (unsigned int v = 0; fast && v < 4; ++v)
              {
                // the columns of the node must be in the order of its dofs
                const auto *dofs = &cell.dofs[n_of_node * v];
                const int  *place =
                  std::find(begin, end, epetra.LCID(static_cast<int>(dofs[0])));
                for (unsigned int j = 0; fast && j < n_of_node; ++j)
                  fast = place + j < end &&
                         place[j] == epetra.LCID(static_cast<int>(dofs[j]));
                cell_places[i][v] = place - columns;
              }
          }
        if (fast)
          {
            fast_cell[c] = places.size();
            places.push_back(std::move(cell_places));
          }
      }
  }


  bool
  TangentMatrix::has(const std::vector<ForceTerm::Coupling> &couplings) const
  {
    return std::all_of(couplings.begin(),
                       couplings.end(),
                       [this](const ForceTerm::Coupling &coupling) {
                         return coupled.count(coupling.nodes) > 0;
                       });
  }


  void
  TangentMatrix::add(const ForceTerm::Coupling &coupling)
  {
    if (!coupling.stiffness.empty())
      // rows and columns of a coupling are free unknowns already
      matrix.add(coupling.rows, coupling.columns, coupling.stiffness, false);
  }


  void
  TangentMatrix::add(const unsigned int               cell,
                     const MixedElement::NodalMatrix &tangent,
                     const MixedElement::NodalVector &force,
                     LA::Vector                      &global_vector)
  {
    const Cell &data = mesh.cells[cell];
    if (data.contributions.empty())
      {
        add_to_nodes(cell, tangent[0].data(), force.begin_raw(), global_vector);
        return;
      }
    data.to_nodes(tangent, matrix_of_nodes);
    data.to_nodes(force, of_nodes);
    add_to_nodes(cell, matrix_of_nodes.data(), of_nodes.data(), global_vector);
  }


  void
  TangentMatrix::add(const Cell                      &element,
                     const MixedElement::NodalMatrix &tangent,
                     const MixedElement::NodalVector &force,
                     LA::Vector                      &global_vector)
  {
    element.to_nodes(tangent, matrix_of_nodes);
    element.to_nodes(force, of_nodes);
    add_with_constraints(
      element, matrix_of_nodes.data(), of_nodes.data(), global_vector);
  }


  namespace
  {
    /** Add the rows of a cell to the values of a matrix.
     * @param n_of_node the number of columns of a node. */
    template <typename Places>
    inline void
    add_rows(const Places      &places,
             const double      *cell_matrix,
             const unsigned int n_of_node,
             double            *values)
    {
      for (const auto &row : places)
        for (unsigned int v = 0; v < 4; ++v, cell_matrix += n_of_node)
          {
            double *place = values + row[v];
            for (unsigned int j = 0; j < n_of_node; ++j)
              place[j] += cell_matrix[j];
          }
    }
  } // namespace


  void
  TangentMatrix::add_to_nodes(const unsigned int cell,
                              const double      *cell_matrix,
                              const double      *cell_vector,
                              LA::Vector        &global_vector)
  {
    const Cell &data = mesh.cells[cell];
    if (fast_cell[cell] == numbers::invalid_unsigned_int)
      {
        add_with_constraints(data, cell_matrix, cell_vector, global_vector);
        return;
      }
    const Places &cell_places = places[fast_cell[cell]];
    // a length known to the compiler in the most frequent case
    if (mesh.n_dofs_per_node() == 6)
      add_rows(cell_places, cell_matrix, 6, values);
    else
      add_rows(cell_places, cell_matrix, mesh.n_dofs_per_node(), values);
    for (unsigned int i = 0; i < data.dofs.size(); ++i)
      global_vector(data.dofs[i]) += cell_vector[i];
  }


  void
  TangentMatrix::add_with_constraints(const Cell   &cell,
                                      const double *cell_matrix,
                                      const double *cell_vector,
                                      LA::Vector   &global_vector)
  {
    const unsigned int n = cell.dofs.size();
    for (unsigned int i = 0; i < n; ++i)
      {
        scratch_vector[i] = cell_vector[i];
        scratch_dofs[i]   = cell.dofs[i];
        for (unsigned int j = 0; j < n; ++j)
          scratch_matrix(i, j) = cell_matrix[n * i + j];
      }
    constraints.distribute_local_to_global(
      scratch_matrix, scratch_vector, scratch_dofs, matrix, global_vector);
  }
} // namespace Biface
