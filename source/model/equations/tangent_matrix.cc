// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

#include <biface/model/equations/tangent_matrix.h>

namespace Biface
{
  using namespace dealii;

  TangentMatrix::TangentMatrix(const ShellMesh                 &mesh,
                               const AffineConstraints<double> &constraints)
    : mesh(mesh)
    , constraints(constraints)
    , fast_cell(mesh.cells.size(), numbers::invalid_unsigned_int)
    , scratch_matrix(MixedElement::n_dofs, MixedElement::n_dofs)
    , scratch_vector(MixedElement::n_dofs)
    , scratch_dofs(MixedElement::n_dofs)
  {
    // deal.II counts the rows of a rank without any as more than an int holds
    const unsigned int n_per_row = (mesh.locally_owned.is_empty() ? 0 : 54);
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
    pattern.compress();
    matrix.reinit(pattern);

    const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
    int                    *row_starts;
    int                    *columns;
    if (epetra.ExtractCrsDataPointers(row_starts, columns, values) != 0)
      return; // not stored contiguously: no fast path

    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        bool        fast = true;
        for (const auto dof : cell.dofs)
          fast = fast && mesh.locally_owned.is_element(dof) &&
                 !constraints.is_constrained(dof);

        Places cell_places;
        for (unsigned int i = 0; fast && i < MixedElement::n_dofs; ++i)
          {
            const int row   = epetra.LRID(static_cast<int>(cell.dofs[i]));
            int      *begin = columns + row_starts[row];
            int      *end   = columns + row_starts[row + 1];
            for (unsigned int v = 0; fast && v < 4; ++v)
              {
                // the columns of the node must be in the order of its dofs
                const int *place = std::find(
                  begin, end, epetra.LCID(static_cast<int>(cell.dofs[6 * v])));
                for (unsigned int j = 0; fast && j < 6; ++j)
                  fast = place + j < end &&
                         place[j] ==
                           epetra.LCID(static_cast<int>(cell.dofs[6 * v + j]));
                cell_places[i][v] = place - columns;
              }
          }
        if (fast)
          {
            fast_cell[c] = places.size();
            places.push_back(cell_places);
          }
      }
  }


  void
  TangentMatrix::add(const unsigned int               cell,
                     const MixedElement::NodalMatrix &tangent,
                     const MixedElement::NodalVector &force,
                     LA::Vector                      &global_vector)
  {
    const Cell &data = mesh.cells[cell];
    if (data.face_offsets)
      {
        MixedElement::NodalMatrix cell_matrix = tangent;
        MixedElement::NodalVector cell_vector = force;
        data.to_nodes(cell_matrix);
        data.to_nodes(cell_vector);
        add_to_nodes(cell, cell_matrix, cell_vector, global_vector);
      }
    else
      add_to_nodes(cell, tangent, force, global_vector);
  }


  void
  TangentMatrix::add_to_nodes(const unsigned int               cell,
                              const MixedElement::NodalMatrix &cell_matrix,
                              const MixedElement::NodalVector &cell_vector,
                              LA::Vector                      &global_vector)
  {
    const Cell &data = mesh.cells[cell];
    if (fast_cell[cell] != numbers::invalid_unsigned_int)
      {
        const Places &cell_places = places[fast_cell[cell]];
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          for (unsigned int v = 0; v < 4; ++v)
            {
              double *place = values + cell_places[i][v];
              for (unsigned int j = 0; j < 6; ++j)
                place[j] += cell_matrix[i][6 * v + j];
            }
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          global_vector(data.dofs[i]) += cell_vector[i];
      }
    else
      {
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          {
            scratch_vector[i] = cell_vector[i];
            scratch_dofs[i]   = data.dofs[i];
            for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
              scratch_matrix(i, j) = cell_matrix[i][j];
          }
        constraints.distribute_local_to_global(
          scratch_matrix, scratch_vector, scratch_dofs, matrix, global_vector);
      }
  }
} // namespace Biface
