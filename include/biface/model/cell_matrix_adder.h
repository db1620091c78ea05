// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_cell_matrix_adder_h
#define biface_model_cell_matrix_adder_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/model/shell_mesh.h>

namespace Biface
{
  /**
   * Adds cell matrices and vectors to the global ones.
   *
   * The pattern of the matrix does not change, and the six columns of a node
   * stand together in every row: for a cell whose rows all belong to this rank
   * and that no constraint touches, the places of its entries are found once.
   * Other cells go through AffineConstraints.
   */
  class CellMatrixAdder
  {
  public:
    /** Set up the pattern of @p matrix and the places of the cells in it. The
     * other arguments are kept by reference; the inhomogeneities of the
     * constraints may change. */
    CellMatrixAdder(const ShellMesh                         &mesh,
                    const dealii::AffineConstraints<double> &constraints,
                    LA::SparseMatrix                        &matrix);

    /** Add the contributions of a cell, given by its position in
     * ShellMesh::cells. */
    void
    add(const unsigned int               cell,
        const MixedElement::NodalMatrix &cell_matrix,
        const MixedElement::NodalVector &cell_vector,
        LA::SparseMatrix                &matrix,
        LA::Vector                      &vector);

  private:
    /** For each row of a cell and each of its four nodes, the place of the
     * first of the node's six columns among the values of the matrix. */
    using Places = std::array<std::array<int, 4>, MixedElement::n_dofs>;

    const ShellMesh                         &mesh;
    const dealii::AffineConstraints<double> &constraints;
    std::vector<Places>                      places;
    /** Position of the cell in @p places, or an invalid number. */
    std::vector<unsigned int> fast_cell;
    /** The values of the matrix, as Epetra stores them. */
    double *values = nullptr;

    dealii::FullMatrix<double>                   scratch_matrix;
    dealii::Vector<double>                       scratch_vector;
    std::vector<dealii::types::global_dof_index> scratch_dofs;
  };
} // namespace Biface

#endif
