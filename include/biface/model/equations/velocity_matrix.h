// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_velocity_matrix_h
#define biface_model_equations_velocity_matrix_h

#include <memory>

#include <biface/base/linear_algebra.h>
#include <biface/model/equations/tangent_matrix.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  class ContactInteraction;


  /**
   * Minus the derivative of the forces on a rolling or spinning shell with
   * respect to velocities @f$\dot{\mathbf u}@f$ of its nodes in the frame of
   * the axle, with the constraints and the sparsity pattern of the tangent.
   *
   * A particle has the acceleration
   * @f$\ddot{\mathbf u}-2\Omega\,\dot{\mathbf u}'+\Omega^2\mathbf x''@f$, see
   * Rolling. The second term is that of Coriolis and of the transport through
   * the mesh; around the closed turn, by parts, its virtual work is
   * @f[
   *   \int\varrho\,\Omega\left(\delta\mathbf u'\cdot\dot{\mathbf u}-
   *   \delta\mathbf u\cdot\dot{\mathbf u}'\right)dV,
   * @f]
   * so that the matrix is skew and does no work. It is summed over the vertices
   * of the cells as in InertiaOfWheel. Friction by slip velocity adds the
   * damping of the nodes in contact.
   */
  class VelocityMatrix
  {
  public:
    /** The mesh is that of @p contact, and is kept by reference.
     * @param loads with Loads::rolling.
     * @param constraints those of the mesh or others, kept by reference;
     * products are for those of the mesh. */
    VelocityMatrix(const ContactInteraction                &contact,
                   const State                             &state,
                   const Loads                             &loads,
                   const dealii::AffineConstraints<double> &constraints);

    const LA::SparseMatrix &
    get() const
    {
      return matrix.get();
    }

    /** The product with a vector whose constrained entries do not matter; it
     * leaves nothing on these. */
    void
    vmult(LA::Vector &product, const LA::Vector &v) const;

    /** The product with the transposed matrix, see vmult(). */
    void
    Tvmult(LA::Vector &product, const LA::Vector &v) const;

  private:
    const ShellMesh &mesh;
    TangentMatrix    matrix;
  };


  /** The velocity matrix if the shell rolls; null otherwise. */
  std::unique_ptr<const VelocityMatrix>
  make_velocity_matrix(const ContactInteraction &contact,
                       const State              &state,
                       const Loads              &loads);
} // namespace Biface

#endif
