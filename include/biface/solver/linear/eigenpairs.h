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
      /** The values of largest magnitude: @f$\lambda@f$ closest to the
       * shift. */
      nearest,
      /** The values of largest real part: the next @f$\lambda@f$ above the
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

    /** The tolerance of @f$\theta@f$ relative to its magnitude. The eigenvalues
     * alone would allow a larger one, with which the shapes of close
     * eigenvalues mix. */
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


  /** The eigenvalue problem @f$(\mathbf K+i\omega\,\mathbf G-\omega^2\,\mathbf
   * M)\mathbf x=\mathbf 0@f$ with real matrices, as operators. */
  struct QuadraticEigenvalueProblem
  {
    /** Solve @f$(\mathbf K+\sigma\mathbf G+\sigma^2\mathbf M)\mathbf
     * x=\mathbf b@f$.
     * @return whether this succeeded, the same on all ranks. */
    std::function<bool(LA::Vector &x, const LA::Vector &b)> solve;

    /** The products with @f$\mathbf G@f$ and @f$\mathbf M@f$. */
    std::function<void(LA::Vector &product, const LA::Vector &x)>
      multiply_velocity, multiply_mass;

    /** The shift @f$\sigma@f$ of @f$i\omega@f$. */
    double shift = 0;

    /** Whether @f$\mathbf K@f$ is symmetric and @f$\mathbf G@f$ skew: then
     * @f$-\omega@f$ is an eigenvalue, too. */
    bool conservative = true;

    /** The tolerance of the eigenvalues relative to their magnitude, see
     * EigenvalueProblem::tolerance. */
    double tolerance = 1e-12;
  };


  /** Whether two eigenvalues are the same up to round-off. */
  bool
  are_same(const std::complex<double> &a, const std::complex<double> &b);

  /** The product with a matrix. */
  using Multiply =
    std::function<void(LA::Vector &product, const LA::Vector &x)>;

  /** The product of a matrix with the vector of a pair. */
  Eigenpair
  product(const Multiply &multiply, const Eigenpair &x);

  /** The product @f$\mathbf y^T\mathbf x@f$ of the vectors of two pairs,
   * without conjugation. */
  std::complex<double>
  product(const Eigenpair &y, const Eigenpair &x);


  /** A linear combination of the vectors of pairs. */
  Eigenpair
  combination(const std::vector<std::complex<double>> &factors,
              const std::vector<Eigenpair>            &pairs);


  /**
   * Make an eigenvalue of a real matrix real whose imaginary part is round-off,
   * with a real vector. Round-off makes a conjugate pair of a double
   * eigenvalue; the real part of the vector then goes to one of them, the
   * imaginary part to the other, since both together span its space.
   */
  void
  make_real(Eigenpair &pair);


  /**
   * The left eigenvectors of a problem @f$\mathbf P(\lambda)@f$,
   * @f$\mathbf y^T\mathbf P=\mathbf 0@f$, such that
   * @f$\mathbf y_i^T\mathbf P'\mathbf x_j=\delta_{ij}@f$ for the right ones
   * @f$\mathbf x_i@f$ of the same eigenvalue.
   *
   * @param right in the order of the eigenvalues.
   * @param found eigenpairs of the transposed problem.
   * @param multiply_derivative the product of the derivative
   * @f$\mathbf P'@f$ at the eigenvalue of a pair with its vector.
   * @return for each of the right ones; with an empty vector, if its eigenvalue
   * was not found or is defective, so that it has no derivative.
   */
  std::vector<Eigenpair>
  left_eigenpairs(
    const std::vector<Eigenpair>                      &right,
    std::vector<Eigenpair>                             found,
    const std::function<Eigenpair(const Eigenpair &)> &multiply_derivative);


  /** Right eigenvectors @f$\mathbf x@f$, in the order of the eigenvalues, and
   * the left ones @f$\mathbf y@f$ with the same eigenvalues, which may be
   * missing, see left_eigenpairs(). */
  struct BothEigenpairs
  {
    std::vector<Eigenpair> right, left;
  };

  /**
   * Rayleigh's quotients
   * @f$\mathbf y^T\mathbf A\mathbf x/\mathbf y^T\mathbf B\mathbf x@f$ for the
   * eigenvectors of a slightly different problem, from whose eigenvalues they
   * deviate by terms of second order @cite Lancaster1964. The quotients of a
   * multiple eigenvalue are replaced by their mean: its vectors are arbitrary,
   * but this mean is not. Without a left vector, the quotient is NaN.
   *
   * @param multiply_a, multiply_b the products with both matrices.
   */
  std::vector<std::complex<double>>
  rayleigh_quotients(const Multiply       &multiply_a,
                     const Multiply       &multiply_b,
                     const BothEigenpairs &neighbors);

  /** The roots @f$\omega@f$ of @f$\mathbf y^T(\mathbf K+i\omega\,\mathbf
   * G-\omega^2\,\mathbf M)\mathbf x=0@f$ closest to those of a slightly
   * different problem, whose eigenvectors are given, see
   * rayleigh_quotients(). */
  std::vector<std::complex<double>>
  rayleigh_roots(const Multiply       &multiply_k,
                 const Multiply       &multiply_g,
                 const Multiply       &multiply_m,
                 const BothEigenpairs &neighbors);


  /** The result of an eigenvalue solver. */
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
   * The eigenvalues @f$\omega@f$ with @f$i\omega@f$ closest to the shift, by
   * the method of Arnoldi of ARPACK, in ascending order of their magnitude.
   * With @f$i\omega=\sigma+s@f$, @f$\mathbf x@f$ and
   * @f$\mathbf w=(s/\omega_0)\mathbf x@f$ are an eigenvector of
   * @f[
   *   \frac{\omega_0}s\binom{\mathbf x}{\mathbf w}=
   *   \binom{-(\mathbf K+\sigma\mathbf G+\sigma^2\mathbf M)^{-1}
   *     \left(\omega_0(\mathbf G+2\sigma\mathbf M)\mathbf x+
   *     \omega_0^2\mathbf M\mathbf w\right)}{\mathbf x},
   * @f]
   * see @cite TisseurMeerbergen2001, with a magnitude @f$\omega_0@f$ of the
   * lowest eigenvalues, for which both parts are of the same size. Must be
   * called on all ranks.
   *
   * Of @f$\omega@f$ and @f$-\bar\omega@f$, which are the same motion, the one
   * with @f$\Re\omega>0@f$ is returned; of a conservative problem, without
   * real part the one with @f$\Im\omega<0@f$, which grows.
   *
   * @param n the number of eigenvalues at least.
   * @param start a vector that contains all eigenvectors.
   */
  Eigenpairs
  nearest_eigenpairs(const QuadraticEigenvalueProblem &problem,
                     const unsigned int                n,
                     const LA::Vector                 &start);


  /** Choose the phases of complex eigenvectors and the signs of real ones such
   * that they do not depend on the order of summation: the product with the
   * first field that is contained in a vector is real and positive. The vectors
   * become unit vectors.
   *
   * @param multiply the product with a symmetric positive semidefinite matrix,
   * for which they do. */
  void
  normalize_phases(std::vector<Eigenpair>                         &pairs,
                   const std::function<void(LA::Vector       &product,
                                            const LA::Vector &x)> &multiply,
                   const std::vector<LA::Vector>                  &fields);


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
