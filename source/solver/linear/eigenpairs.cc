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
    using Multiply =
      std::function<void(LA::Vector &product, const LA::Vector &x)>;


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


    /** Make the products with a matrix of real vectors those of the unit
     * matrix. */
    void
    orthonormalize(std::vector<LA::Vector> &vectors, const Multiply &multiply)
    {
      if (vectors.empty())
        return;
      LA::Vector product(vectors[0]);
      for (unsigned int i = 0; i < vectors.size(); ++i)
        {
          // twice is enough
          for (unsigned int pass = 0; pass < 2; ++pass)
            for (unsigned int j = 0; j < i; ++j)
              {
                multiply(product, vectors[i]);
                vectors[i].add(-(product * vectors[j]), vectors[j]);
              }
          multiply(product, vectors[i]);
          vectors[i] /= std::sqrt(product * vectors[i]);
        }
    }
  } // namespace


  Eigenpairs
  nearest_eigenpairs(const EigenvalueProblem &problem,
                     const unsigned int       n,
                     const LA::Vector        &start)
  {
    using Arpack = PArpackSolver<LA::Vector>;

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

    const auto which = (problem.wanted == EigenvalueProblem::Wanted::nearest
                          ? Arpack::largest_magnitude
                        : problem.symmetric ? Arpack::algebraically_largest
                                            : Arpack::largest_real_part);

    std::vector<std::complex<double>> values(n);
    std::vector<LA::Vector>           vectors(n + 1, start);
    try
      {
        SolverControl control(max_restarts, problem.tolerance, false, false);
        Arpack        solver(
          control,
          start.get_mpi_communicator(),
          Arpack::AdditionalData(n_basis, which, problem.symmetric));
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


  bool
  are_same(const std::complex<double> &a, const std::complex<double> &b)
  {
    constexpr double same = 1e-7;
    return std::abs(b - a) <= same * std::abs(b);
  }


  void
  settle(std::vector<Eigenpair>        &pairs,
         const Multiply                &multiply,
         const std::vector<LA::Vector> &fields)
  {
    // the part of a field in a group of vectors that is not round-off
    constexpr double significant = 1e-5;

    std::stable_sort(
      pairs.begin(), pairs.end(), [](const auto &a, const auto &b) {
        return a.value.real() < b.value.real();
      });

    if (pairs.empty())
      return;
    LA::Vector product(pairs[0].vector);
    for (unsigned int begin = 0, end = 0; begin < pairs.size(); begin = end)
      {
        end                   = begin + 1;
        const bool is_complex = (pairs[begin].value.imag() != 0);
        while (end < pairs.size() && !is_complex &&
               pairs[end].value.imag() == 0 &&
               are_same(pairs[end - 1].value, pairs[end].value))
          ++end;

        if (is_complex)
          {
            // the phase with the largest real part
            LA::Vector &a = pairs[begin].vector;
            LA::Vector &b = pairs[begin].imaginary;
            multiply(product, a);
            const double aa = product * a, ab = product * b;
            multiply(product, b);
            const double phase = -std::atan2(2 * ab, aa - product * b) / 2;
            LA::Vector   old_a(a);
            a *= std::cos(phase);
            a.add(-std::sin(phase), b);
            b *= std::cos(phase);
            b.add(std::sin(phase), old_a);
          }

        std::vector<LA::Vector> vectors;
        for (unsigned int i = begin; i < end; ++i)
          vectors.push_back(pairs[i].vector);
        if (!is_complex)
          orthonormalize(vectors, multiply);

        // Each field in turn selects the one of the remaining combinations of
        // the vectors that contains most of it.
        const unsigned int               n = vectors.size();
        std::vector<std::vector<double>> chosen;
        for (const LA::Vector &field : fields)
          {
            if (chosen.size() == n)
              break;
            std::vector<double> c(n);
            for (unsigned int i = 0; i < n; ++i)
              c[i] = field * vectors[i];
            double norm = 0;
            for (unsigned int pass = 0; pass < 2; ++pass)
              {
                for (const auto &other : chosen)
                  {
                    double dot = 0;
                    for (unsigned int i = 0; i < n; ++i)
                      dot += other[i] * c[i];
                    for (unsigned int i = 0; i < n; ++i)
                      c[i] -= dot * other[i];
                  }
                norm = 0;
                for (const double entry : c)
                  norm += entry * entry;
                norm = std::sqrt(norm);
              }
            if (norm < significant)
              continue;
            for (double &entry : c)
              entry /= norm;
            chosen.push_back(c);
          }
        if (chosen.size() < n)
          continue;
        for (unsigned int k = 0; k < n; ++k)
          {
            LA::Vector &vector = pairs[begin + k].vector;
            vector             = 0;
            for (unsigned int i = 0; i < n; ++i)
              vector.add(chosen[k][i], vectors[i]);
            if (is_complex)
              pairs[begin].imaginary *= chosen[k][k];
          }
      }
  }
} // namespace Biface
