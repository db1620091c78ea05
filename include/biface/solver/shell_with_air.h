// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_shell_with_air_h
#define biface_solver_shell_with_air_h

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/air/air_column.h>
#include <biface/model/equations/mass_matrix.h>

namespace Biface
{
  /**
   * A shell that vibrates with the air in it: vectors of its unknowns
   * @f$\mathbf u@f$ and of the volumes @f$\mathbf q@f$ that have moved through
   * the sections of an AirMotion, which are unknowns of the last rank. With the
   * columns @f$(\mathbf g_c,\mathbf e_c)@f$ of @f$\mathbf W@f$, the derivative
   * of the expansion of the pieces, and their stiffness @f$\mathbf D=B/V_c@f$,
   * the stiffness is
   * @f[
   *   \begin{pmatrix}\mathbf K&\mathbf 0\\\mathbf 0&\mathbf 0\end{pmatrix}
   *   +\mathbf W\mathbf D\mathbf W^T .
   * @f]
   */
  class ShellWithAir
  {
  public:
    /** The objects are kept by reference. */
    ShellWithAir(const ShellMesh  &mesh,
                 const MassMatrix &mass,
                 const AirMotion  &air);

    /** The vector of the shell and the air.
     * @param q the same on all ranks. */
    LA::Vector
    join(const LA::Vector &u, const std::vector<double> &q) const;

    /** Displacements with air that moves in arbitrary ways. */
    LA::Vector
    with_arbitrary_air(const LA::Vector &u) const;

    /** Displacements with air at rest. */
    LA::Vector
    with_air_at_rest(const LA::Vector &u) const
    {
      return join(u, std::vector<double>(air.sections.size(), 0.));
    }

    LA::Vector
    of_shell(const LA::Vector &x) const;

    /** The volumes, on all ranks. */
    std::vector<double>
    of_air(const LA::Vector &x) const;

    void
    multiply_mass(LA::Vector &product, const LA::Vector &x) const;

    /** The motion of the air around the axis that has no stiffness; empty if
     * there is none. */
    std::vector<LA::Vector>
    circulation() const;

    /** The part of the shell in the kinetic energy of a motion; the rest is
     * that of the air. */
    double
    part_of_shell(const LA::Vector &x) const;

    /** The momentum of the air along x, y and z if the vector is a velocity. */
    dealii::Tensor<1, 3>
    momentum_of_air(const LA::Vector &x) const;

    /** Solve a system of the shell alone, and return whether this succeeded. */
    using Solve = std::function<bool(LA::Vector &x, const LA::Vector &b)>;

    /** Prepare to solve systems with the stiffness of shell and air minus
     * @p shift, which is negative, times the mass.
     * @param solve systems of the shell with that shift.
     * @return whether this succeeded. */
    bool
    prepare(const Solve &solve, const double shift);

    bool
    solve(LA::Vector &x, const LA::Vector &b, const Solve &solve) const;

  private:
    /** The gradient of the volume of a piece, in the free unknowns. */
    LA::Vector
    gradient(const unsigned int piece) const;

    /** The products of the columns of @f$\mathbf W@f$ with a vector. */
    std::vector<double>
    expansion(const LA::Vector &u, const std::vector<double> &q) const;

    const ShellMesh  &mesh;
    const MassMatrix &mass;
    const AirMotion  &air;
    dealii::IndexSet  owned;
    bool              is_last;
    double            shift = 0;
    /** The displacements of the shell per unit pressure in each piece. */
    std::vector<LA::Vector> per_pressure;
    /** The inverse of @f$\mathbf D^{-1}+\mathbf W^T\mathbf A^{-1}\mathbf
     * W@f$ with the shifted matrix @f$\mathbf A@f$ of shell and air without the
     * stiffness of the air. */
    dealii::FullMatrix<double> inverse;
  };
} // namespace Biface

#endif
