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
   * The angle by which two directors @f$\mathbf w_1,\mathbf w_2@f$ have turned
   * against each other about the direction @f$\mathbf t@f$ of the line where
   * they meet, and its derivatives:
   * @f[
   *   \vartheta = \Delta\arctan
   *     \frac{\mathbf t\cdot(\mathbf w_1\times\mathbf w_2)}
   *     {|\mathbf t|\,\bigl(\mathbf w_1\cdot\mathbf w_2 -
   *      (\mathbf w_1\cdot\mathbf t)(\mathbf w_2\cdot\mathbf t)/t^2\bigr)} ,
   * @f]
   * where @f$\Delta@f$ is the change, between -180 and 180 degrees. It is zero
   * in rigid motions and for changes of the lengths of the three vectors, see
   * section "Folds and joints" of doc/theory.md.
   */
  struct JointAngle
  {
    /** The half differences @f$\mathbf w_1,\mathbf w_2@f$ of the faces, and
     * @f$\mathbf t@f$. */
    using Vectors = std::array<dealii::Tensor<1, 3>, 3>;

    double angle;
    /** The derivatives by the changes of the vectors. Unit: 1/length. */
    Vectors gradient;
    /** The second derivatives. Unit: 1/length². */
    std::array<std::array<dealii::Tensor<2, 3>, 3>, 3> curvature;

    /**
     * @param undeformed the vectors in the undeformed shell.
     * @param change their changes.
     */
    JointAngle(const Vectors &undeformed, const Vectors &change);
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
    /** The mesh is kept by reference. */
    explicit Joints(const ShellMesh &mesh);

    std::vector<const Cell *>
    elements() const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const override;

    double
    stored_energy(const State &state) const override;

    double
    dissipated_energy(const State &state) const override;

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
      /** From the first to the second end, in the middle between the faces of
       * the first part. Unit: length. */
      dealii::Tensor<1, 3> line;
      /** The moments per angle at the ends; zero where both parts have the same
       * node. Unit: force times length. */
      std::array<double, 2> stiffness;
    };

    /** An unknown vector of a pair, on which one of the vectors of JointAngle
     * depends. */
    struct Unknown
    {
      unsigned int       vertex;
      MixedElement::Part part;
      /** The position in JointAngle::Vectors, and the derivative of that vector
       * in space by the one in space. */
      unsigned int vector;
      double       sign;
    };

    /** Add a moment at an end and its derivative.
     * @param joint gives the derivatives of the angle.
     * @param per_angle the derivative of the moment by the angle.
     * @param of_tangent the derivative of the displacements by those for which
     * the tangent is. */
    void
    add_moment(const Pair        &pair,
               const unsigned int end,
               const JointAngle  &joint,
               const double       moment,
               const double       per_angle,
               const double       of_tangent,
               CellForces        &forces) const;

    /** The unknowns on which the angle at an end depends. */
    static std::array<Unknown, 4>
    unknowns(const unsigned int end);

    /** The vectors at an end of a pair in the undeformed shell. */
    static JointAngle::Vectors
    undeformed(const Pair &pair, const unsigned int end);

    /** The changes of the vectors at an end of a pair, in space. */
    static JointAngle::Vectors
    change(const Pair                      &pair,
           const unsigned int               end,
           const MixedElement::NodalVector &V);

    const ShellMesh  &mesh;
    std::vector<Pair> pairs;
  };
} // namespace Biface

#endif
