// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_gas_stiffness_h
#define biface_solver_gas_stiffness_h

#include <functional>

#include <biface/base/linear_algebra.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/gas.h>
#include <biface/model/state/state.h>

namespace Biface
{
  /**
   * The part of rank one that a sealed gas adds to a tangent,
   * @f$-\mathbf f\otimes\mathbf g@f$ with the forces @f$\mathbf f@f$ of a unit
   * pressure and the derivative @f$\mathbf g@f$ of the pressure by the
   * displacements, see Gas. Systems with it are solved with those of a matrix
   * without it.
   */
  class GasStiffness
  {
  public:
    /** @param state, loads an equilibrium; its foundation does not matter.
     * @param gas in the shell. */
    GasStiffness(const ShellEquations &equations,
                 const State          &state,
                 const Loads          &loads,
                 const Gas::Sealed    &gas);

    /** Whether the term is symmetric up to round-off: the pressure pushes where
     * the volume grows, and nowhere else. */
    bool
    is_symmetric() const;

    /** Add a multiple of the product with @p x. */
    void
    vmult_add(LA::Vector       &product,
              const LA::Vector &x,
              const double      factor = 1) const;

    /** Likewise with the transposed term. */
    void
    Tvmult_add(LA::Vector       &product,
               const LA::Vector &x,
               const double      factor = 1) const;

    /** Replace this by @p s times this plus @p a times @p other, which has the
     * same displacements. */
    void
    sadd(const double s, const double a, const GasStiffness &other);

    /** The transposed term, not prepared. */
    GasStiffness
    transposed() const;

    /** Solve a system with a matrix, and return whether this succeeded. */
    using Solve = std::function<bool(LA::Vector &x, const LA::Vector &b)>;

    /** Prepare to correct solutions of systems with a matrix.
     * @return whether this succeeded; not if the sum is singular. */
    bool
    prepare(const Solve &solve);

    /** Turn a solution of a system with the matrix into that with the sum.
     * @param by_supports the change of the pressure by displacements that
     * supports prescribe. */
    void
    correct(LA::Vector &x, const double by_supports = 0) const;

    /** The number of negative eigenvalues of the sum, if both parts are
     * symmetric, from those of the matrix. */
    unsigned int
    n_negative(const unsigned int of_matrix) const;

  private:
    LA::Vector forces;
    LA::Vector pressure_gradient;
    /** The displacements per unit of the pressure, and the determinant of the
     * sum relative to that of the matrix; see prepare(). */
    LA::Vector per_pressure;
    double     determinant = 1;
  };
} // namespace Biface

#endif
