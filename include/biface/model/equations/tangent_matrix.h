// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_tangent_matrix_h
#define biface_model_equations_tangent_matrix_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <set>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The global tangent, to which cell matrices are added.
   *
   * The sparsity pattern is fixed, and the columns of a node are contiguous in
   * every row. For a cell without constraints whose rows all belong to this
   * rank, the positions of its entries are therefore found once. Other cells
   * are added by AffineConstraints.
   */
  class TangentMatrix
  {
  public:
    /** Mesh and constraints are kept by reference; the inhomogeneities of the
     * constraints may change.
     * @param couplings between nodes that share no cell, for which the matrix
     * has entries.
     * @param elements others than those of the mesh that will be added. */
    TangentMatrix(const ShellMesh                         &mesh,
                  const dealii::AffineConstraints<double> &constraints,
                  const std::vector<ForceTerm::Coupling>  &couplings = {},
                  const std::vector<const Cell *>         &elements  = {});

    /** Not copied: it points into the values of its matrix. */
    TangentMatrix(const TangentMatrix &) = delete;

    /** Set all entries to zero. */
    void
    clear()
    {
      matrix = 0;
    }

    /** Add the matrix of a cell, given by its position in ShellMesh::cells, and
     * its vector to @p global_vector, including the effect of inhomogeneous
     * constraints. */
    void
    add(const unsigned int               cell,
        const MixedElement::NodalMatrix &cell_matrix,
        const MixedElement::NodalVector &cell_vector,
        LA::Vector                      &global_vector);

    /** Add the matrix and the vector of an element between the nodes of a
     * cell. */
    void
    add(const Cell                      &element,
        const MixedElement::NodalMatrix &cell_matrix,
        const MixedElement::NodalVector &cell_vector,
        LA::Vector                      &global_vector);

    /** Whether the matrix has entries for all couplings. */
    bool
    has(const std::vector<ForceTerm::Coupling> &couplings) const;

    /** Add a coupling for which the matrix has entries. */
    void
    add(const ForceTerm::Coupling &coupling);

    /** Collect the entries that other ranks have added. */
    void
    compress()
    {
      matrix.compress(dealii::VectorOperation::add);
    }

    const LA::SparseMatrix &
    get() const
    {
      return matrix;
    }

  private:
    /** Add a matrix, row by row, and a vector for the unknowns of the nodes of
     * a cell, in the order of Cell::dofs. */
    void
    add_to_nodes(const unsigned int cell,
                 const double      *cell_matrix,
                 const double      *cell_vector,
                 LA::Vector        &global_vector);

    /** Add a matrix and a vector for the unknowns of the nodes of a cell by
     * AffineConstraints. */
    void
    add_with_constraints(const Cell   &cell,
                         const double *cell_matrix,
                         const double *cell_vector,
                         LA::Vector   &global_vector);

    /** The position of the first column of each of the four nodes of a cell
     * among the values of the matrix, for each row of the cell. */
    using Places = std::vector<std::array<int, 4>>;

    const ShellMesh                         &mesh;
    const dealii::AffineConstraints<double> &constraints;
    LA::SparseMatrix                         matrix;
    std::vector<Places>                      places;
    /** The position of the cell in @p places, or an invalid number; the same
     * for all elements on a cell of the triangulation. */
    std::vector<unsigned int> fast_cell;
    /** The pairs of nodes that are coupled. */
    std::set<decltype(ForceTerm::Coupling::nodes)> coupled;
    /** The values of the matrix, as Epetra stores them. */
    double *values = nullptr;

    std::vector<double>                          of_nodes, matrix_of_nodes;
    dealii::FullMatrix<double>                   scratch_matrix;
    dealii::Vector<double>                       scratch_vector;
    std::vector<dealii::types::global_dof_index> scratch_dofs;
  };
} // namespace Biface

#endif
