// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_low_rank_stiffness_h
#define biface_solver_low_rank_stiffness_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <functional>
#include <optional>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/equations/equation_system.h>

namespace Biface
{
  /**
   * The part of low rank that loads depending on the displacements of the whole
   * shell add to a tangent @f$\mathbf K@f$, such as the pressure of a sealed
   * gas: @f$-\mathbf F\mathbf G^T@f$ with a column of @f$\mathbf F@f$ and
   * @f$\mathbf G@f$ for each EquationSystem::RankOne. Systems with the sum are
   * solved with those of @f$\mathbf K@f$ by the Woodbury formula
   * @cite GolubVanLoan2013. Mostly, the rank is 0, and nothing is done.
   */
  class LowRankStiffness
  {
  public:
    /** A part of rank 0. */
    LowRankStiffness() = default;

    /** The part at an equilibrium.
     * @param state, loads an equilibrium; its ground does not matter. */
    LowRankStiffness(const EquationSystem &equations,
                     const State          &state,
                     const Loads          &loads);

    bool
    is_zero() const
    {
      return parts.empty();
    }

    /** Whether the part is symmetric up to round-off. */
    bool
    is_symmetric() const;

    /** Add a multiple of the product of the part with @p x. */
    void
    vmult_add(LA::Vector       &product,
              const LA::Vector &x,
              const double      factor = 1) const;

    /** Add a multiple of the product of the transposed part with @p x. */
    void
    Tvmult_add(LA::Vector       &product,
               const LA::Vector &x,
               const double      factor = 1) const;

    /** Replace this by @p s times this plus @p a times @p other, which has the
     * same forces. */
    void
    sadd(const double s, const double a, const LowRankStiffness &other);

    /** The transposed part, not prepared. */
    LowRankStiffness
    transposed() const;

    /** Solve a system with a matrix, and return whether this succeeded. */
    using Solve = std::function<bool(LA::Vector &x, const LA::Vector &b)>;

    /** Prepare to correct solutions of systems with a matrix.
     * @return whether this succeeded; not if the sum is singular. */
    bool
    prepare(const Solve &solve);

    /** Turn a solution of a system with the matrix into that with the sum.
     * @param supports displacements that supports prescribe; null if they are
     * zero. */
    void
    correct(LA::Vector &x, const LA::Vector *supports = nullptr) const;

    /** Turn the solution for the forces of a load parameter into the motion of
     * all unknowns, those of supports included. */
    void
    complete(LA::Vector                               &x,
             const EquationSystem::ParameterDirection &direction) const;

    /** The number of negative eigenvalues of the sum from the number of those
     * of the matrix, which is symmetric; none if the part is not, or is not
     * prepared. */
    std::optional<unsigned int>
    n_negative(const unsigned int of_matrix) const;

  private:
    struct Part
    {
      /** A column of @f$\mathbf F@f$ and of @f$\mathbf G@f$. */
      LA::Vector forces, gradient;
      /** The gradient with its entries at supports. */
      LA::Vector gradient_with_supports;
      /** The displacements @f$\mathbf K^{-1}@f$ times the forces, see
       * prepare(). */
      LA::Vector solution;

      /** The factor d in @f$\mathbf f=d\,\mathbf g@f$ of forces and gradient,
       * if they are parallel. */
      double
      proportion() const
      {
        return (forces * gradient) / gradient.norm_sqr();
      }
    };

    std::vector<Part> parts;
    /** The inverse of @f$\mathbf I-\mathbf G^T\mathbf K^{-1}\mathbf F@f$. */
    dealii::FullMatrix<double> inverse;
  };
} // namespace Biface

#endif
