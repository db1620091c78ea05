// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_mass_matrix_h
#define biface_model_equations_mass_matrix_h

#include <biface/base/linear_algebra.h>
#include <biface/element/mixed_element.h>
#include <biface/model/equations/tangent_matrix.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /** The mass matrix of a layer in the unknowns of its nodes, see
   * element_mass(). */
  MixedElement::NodalMatrix
  cell_mass(const ShellMesh &mesh, const Cell &cell);

  /** The inertia of any displacements, supported nodes included: the nodal
   * forces that give them an acceleration of the same value.
   * @param V with the entries of all nodes of this rank. */
  LA::Vector
  inertia(const ShellMesh &mesh, const LA::Vector &V);


  /**
   * The mass matrix of the shell, see element_mass(), with the constraints and
   * the sparsity pattern of the tangent.
   *
   * A product with it is that of the free unknowns: it leaves nothing on
   * constrained ones.
   */
  class MassMatrix
  {
  public:
    /** The mesh is kept by reference. */
    explicit MassMatrix(const ShellMesh &mesh);

    /** The matrix, with arbitrary entries on the diagonal of constrained
     * unknowns. */
    const LA::SparseMatrix &
    get() const
    {
      return matrix.get();
    }

    /** The product with a vector whose constrained entries do not matter. */
    void
    vmult(LA::Vector &product, const LA::Vector &v) const;

    /** The mass of the whole shell. Unit: mass. */
    double
    total() const
    {
      return total_mass;
    }

  private:
    const ShellMesh &mesh;
    TangentMatrix    matrix;
    double           total_mass = 0;
  };
} // namespace Biface

#endif
