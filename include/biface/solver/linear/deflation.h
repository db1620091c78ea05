// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_deflation_h
#define biface_solver_linear_deflation_h

#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <vector>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  /**
   * Restricts the systems of an eigenvalue problem to vectors that are
   * orthogonal to given ones @f$\mathbf r_i@f$ in the product with a symmetric
   * matrix @f$\mathbf C@f$: it solves
   * @f$\mathbf A\mathbf x+\mathbf C\mathbf R\boldsymbol\lambda=\mathbf b@f$,
   * @f$\mathbf R^T\mathbf C\mathbf x=\mathbf 0@f$ with solutions of systems
   * with
   * @f$\mathbf A@f$, which may be nearly singular for the given vectors.
   */
  class Deflation
  {
  public:
    /**
     * @param vectors become orthonormal in the product with @f$\mathbf C@f$.
     * @param multiply the product with @f$\mathbf C@f$.
     */
    Deflation(const std::vector<LA::Vector>                  &vectors,
              const std::function<void(LA::Vector       &product,
                                       const LA::Vector &x)> &multiply);

    /** The orthonormal vectors. */
    const std::vector<LA::Vector> &
    get_vectors() const
    {
      return vectors;
    }

    /** Solve a system with @f$\mathbf A@f$, and return whether this succeeded.
     */
    using Solve = std::function<bool(LA::Vector &x, const LA::Vector &b)>;

    /** Prepare to solve systems with a matrix.
     * @return whether this succeeded. */
    bool
    prepare(const Solve &solve);

    /** Solve the restricted system.
     * @return whether this succeeded. */
    bool
    solve(LA::Vector &x, const LA::Vector &b, const Solve &solve) const;

    /** The number of negative eigenvalues of the restricted matrix, if
     * @f$\mathbf A@f$ is symmetric, from those of @f$\mathbf A@f$. */
    unsigned int
    n_negative(const unsigned int of_matrix) const;

  private:
    /** The vectors @f$\mathbf R@f$, orthonormal in the product with
     * @f$\mathbf C@f$, the products @f$\mathbf C\mathbf R@f$, and the solutions
     * @f$\mathbf A^{-1}\mathbf C\mathbf R@f$ of prepare(). */
    std::vector<LA::Vector> vectors, products, solutions;
    /** The matrix @f$(\mathbf C\mathbf R)^T\mathbf A^{-1}\mathbf C\mathbf R@f$,
     * with a row for each vector, and its inverse. */
    dealii::FullMatrix<double> matrix, inverse;
  };


  /**
   * The null space of a symmetric matrix @f$\mathbf A@f$, spanned by given
   * vectors. The solution of a system whose right hand side is orthogonal to
   * them is determined but for its part in the null space. It is found with a
   * regular matrix, @f$\mathbf A@f$ plus a stiffness of as many single
   * unknowns, which stay at zero in the solution.
   */
  class NullSpace
  {
  public:
    /** The null space of dimension 0. */
    NullSpace() = default;

    /** @param vectors linearly independent. Must be called on all ranks. */
    explicit NullSpace(const std::vector<LA::Vector> &vectors);

    /** An orthonormal basis of the null space. */
    const std::vector<LA::Vector> &
    get_vectors() const
    {
      return vectors;
    }

    /** Make a matrix with this null space regular. */
    void
    pin(LA::SparseMatrix &A) const;

    /** Remove the part of a vector in the null space: of a right hand side, and
     * of the solution with the matrix that pin() has changed. */
    void
    remove_from(LA::Vector &x) const;

  private:
    std::vector<LA::Vector> vectors;
    /** The unknown that is pinned for each of the vectors, the same on all
     * ranks. */
    std::vector<dealii::types::global_dof_index> pinned;
  };
} // namespace Biface

#endif
