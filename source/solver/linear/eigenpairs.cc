// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/parpack_solver.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>

#include <biface/solver/linear/eigenpairs.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A linear system was not solved. */
    struct NotSolved
    {};

    struct Product
    {
      const EigenvalueProblem &problem;

      void
      vmult(LA::Vector &product, const LA::Vector &x) const
      {
        problem.multiply(product, x);
      }
    };

    struct Inverse
    {
      const EigenvalueProblem &problem;

      void
      vmult(LA::Vector &x, const LA::Vector &b) const
      {
        if (!problem.solve(x, b))
          throw NotSolved();
      }
    };
  } // namespace


  Eigenpairs
  nearest_eigenpairs(const EigenvalueProblem &problem,
                     const unsigned int       n,
                     const LA::Vector        &start)
  {
    using Arpack = PArpackSolver<LA::Vector>;

    // of the inverse of the distance from the shift; the frequencies need less,
    // but the shapes of neighboring modes mix
    constexpr double       tolerance    = 1e-12;
    constexpr unsigned int max_restarts = 300;

    Eigenpairs result;
    // more basis vectors make restarts rare
    const unsigned int n_basis = std::min<unsigned int>(
      std::max(2 * n + 2, std::min(2 * n + 10, 3 * n + 6)), start.size() - 1);
    if (n_basis < 2 * n + 2)
      {
        result.message = "the shell has too few unknowns for so many modes";
        return result;
      }

    std::vector<std::complex<double>> values(n);
    std::vector<LA::Vector>           vectors(n + 1, start);
    try
      {
        SolverControl control(max_restarts, tolerance, false, false);
        Arpack        solver(control,
                      start.get_mpi_communicator(),
                      Arpack::AdditionalData(
                        n_basis, Arpack::largest_magnitude, problem.symmetric));
        solver.reinit(start);
        solver.set_initial_vector(start);
        solver.set_shift(problem.shift);
        const Product product{problem};
        solver.solve(product, product, Inverse{problem}, values, vectors, n);
      }
    catch (const NotSolved &)
      {
        result.message = "the tangent is singular or nearly so";
        return result;
      }
    catch (const ExceptionBase &)
      {
        result.message = "the eigenvalue solver ARPACK did not converge";
        return result;
      }

    for (unsigned int i = 0; i < n; ++i)
      {
        Eigenpair pair;
        pair.value  = values[i];
        pair.vector = vectors[i];
        if (values[i].imag() == 0)
          result.pairs.push_back(pair);
        else if (i + 1 < n)
          {
            // the pair shares the two vectors
            pair.imaginary = vectors[i + 1];
            result.pairs.push_back(pair);
            pair.value = std::conj(pair.value);
            pair.imaginary *= -1;
            result.pairs.push_back(pair);
            ++i;
          }
      }
    result.success = true;
    return result;
  }
} // namespace Biface
