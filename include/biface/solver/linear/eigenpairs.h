// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_eigenpairs_h
#define biface_solver_linear_eigenpairs_h

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/solver/failure.h>

namespace Biface
{
  /** The eigenvalue problem @f$\mathbf A\mathbf x=\lambda\mathbf B\mathbf
   * x@f$ with a positive semidefinite @f$\mathbf B@f$, as operators. */
  struct EigenvalueProblem
  {
    /** Which @f$\theta=1/(\lambda-\sigma)@f$ are wanted. */
    enum class Wanted
    {
      /** Those of the greatest magnitude: @f$\lambda@f$ closest to the
       * shift. */
      nearest,
      /** Those of the greatest real part: the next @f$\lambda@f$ above the
       * shift, if they are real. */
      next_above
    };

    /** Solve @f$(\mathbf A-\sigma\mathbf B)\mathbf x=\mathbf b@f$.
     * @return whether this succeeded, the same on all ranks. */
    std::function<bool(LA::Vector &x, const LA::Vector &b)> solve;

    /** The product with @f$\mathbf B@f$. */
    std::function<void(LA::Vector &product, const LA::Vector &x)> multiply;

    /** The shift @f$\sigma@f$. */
    double shift = 0;

    /** Whether @f$\mathbf A@f$ is symmetric. */
    bool symmetric = true;

    Wanted wanted = Wanted::nearest;

    /** Of @f$\theta@f$, relative to its magnitude. The eigenvalues need less
     * than the default, but without it the shapes of neighboring ones mix. */
    double tolerance = 1e-12;
  };


  /** An eigenvalue with its vector. */
  struct Eigenpair
  {
    std::complex<double> value;
    LA::Vector           vector;
    /** The imaginary part of the vector; empty for real eigenvalues. */
    LA::Vector imaginary;
  };


  /** Whether two eigenvalues are the same up to round-off. */
  bool
  are_same(const std::complex<double> &a, const std::complex<double> &b);


  struct Eigenpairs
  {
    bool success = false;
    /** The reason of a failure, as part of a sentence. */
    std::string            message;
    std::vector<Eigenpair> pairs;
  };


  /**
   * The wanted eigenvalues, by the implicitly restarted Lanczos
   * method of ARPACK @cite LehoucqSorensenYang1998 on
   * @f$(\mathbf A-\sigma\mathbf B)^{-1}\mathbf B@f$, or that of Arnoldi if
   * @f$\mathbf A@f$ is not symmetric. Must be called on all ranks.
   *
   * @param n the number of eigenvalues. Of a complex pair, both count.
   * @param start a vector that contains all eigenvectors.
   */
  Eigenpairs
  nearest_eigenpairs(const EigenvalueProblem &problem,
                     const unsigned int       n,
                     const LA::Vector        &start);


  /**
   * Sort pairs by the real part of the eigenvalue, and choose the vectors of
   * the same eigenvalue such that they do not depend on the order of
   * summation: each field in turn selects the one that contains most of it. The
   * phases and signs follow likewise.
   *
   * @param multiply the product with a symmetric positive semidefinite matrix,
   * for which these vectors become orthonormal.
   */
  void
  settle(std::vector<Eigenpair> &pairs,
         const std::function<void(LA::Vector &product, const LA::Vector &x)>
                                       &multiply,
         const std::vector<LA::Vector> &fields);
} // namespace Biface

#endif
