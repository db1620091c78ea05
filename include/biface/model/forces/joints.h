// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_joints_h
#define biface_model_forces_joints_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

#include <biface/model/forces/force_term.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  /**
   * The angle by which two directors have turned against each other, and its
   * derivatives: with the half differences @f$\mathbf W_k@f$ of the faces,
   * @f$\mathbf w_k@f$ in the deformed shell, and the angle @f$\gamma@f$ between
   * @f$\mathbf W_1@f$ and @f$\mathbf W_2@f$,
   * @f[
   *   \vartheta = \frac1{\sin\gamma}\,\Delta\Bigl(
   *     \frac{\mathbf w_1\cdot\mathbf w_2}{W_1W_2} - \frac{\cos\gamma}2
   *     \Bigl(\frac{w_1^2}{W_1^2}+\frac{w_2^2}{W_2^2}\Bigr)\Bigr) ,
   * @f]
   * where @f$\Delta@f$ is the change. It is zero in rigid motions, and of
   * second order in changes of the thickness; section 4.3 of doc/any_mesh.md.
   */
  struct JointAngle
  {
    double angle;
    /** The derivatives by both changes. Unit: 1/length. */
    std::array<dealii::Tensor<1, 3>, 2> gradient;
    /** The factors of the unit tensor in the second derivatives by the changes
     * i and j, constant. Unit: 1/length². */
    std::array<std::array<double, 2>, 2> curvature;

    /**
     * @param W the half differences in the undeformed shell; they must not be
     * parallel.
     * @param change their changes.
     */
    JointAngle(const std::array<dealii::Tensor<1, 3>, 2> &W,
               const std::array<dealii::Tensor<1, 3>, 2> &change);
  };


  /**
   * The moments between the parts of a shell that meet at a fold, at both ends
   * of each side of it: the energy is @f$\frac12 k\,\vartheta^2@f$ times half
   * of the length of the side, with the JointAngle @f$\vartheta@f$.
   *
   * Where parts are joined rigidly, @f$k=100\,B/h@f$ with the bending stiffness
   * B of a part across the side and its thickness h, the smallest of all parts:
   * the joint yields like an additional strip of that part of a hundredth of
   * its thickness.
   */
  class Joints : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. Throws InputError on all ranks if the
     * directors of two parts that are joined are nearly parallel at a node. */
    Joints(const ShellMesh &mesh);

    std::vector<const Cell *>
    elements() const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    double
    strain_energy(const State &state) const override;

    Source
    source() const override
    {
      return Source::shell;
    }

  private:
    /** Two parts at a side: the vertices 0 and 1 are the ends of the first,
     * 2 and 3 those of the second. */
    struct Pair
    {
      Cell element;
      /** The moments per angle at the ends; zero where both parts have the same
       * node. Unit: force times length. */
      std::array<double, 2> stiffness;
    };

    /** The change of the directors of a pair at one end, in space, and the axes
     * of their nodes. */
    struct Directors
    {
      std::array<dealii::Tensor<1, 3>, 2> undeformed, change;
      std::array<dealii::Tensor<2, 3>, 2> axes;

      Directors(const Pair                      &pair,
                const unsigned int               end,
                const MixedElement::NodalVector &V);
    };

    const ShellMesh  &mesh;
    std::vector<Pair> pairs;
  };
} // namespace Biface

#endif
