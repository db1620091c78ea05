// SPDX-License-Identifier: LGPL-2.1-or-later

// With right and left eigenvectors, Rayleigh's quotients predict the
// eigenvalues of a neighboring unsymmetric problem up to terms of second order:
// real and complex ones, and the mean of double ones. A defective eigenvalue
// has no left eigenvector whose product with the right one is not zero.

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <cmath>
#include <iostream>

#include <biface/solver/linear/eigenpairs.h>
#include <biface/solver/linear/mumps_solver.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  constexpr unsigned int n = 30;


  /** Two copies of the same chain, whose entries above and below the diagonal
   * differ. */
  struct Chains
  {
    LA::SparseMatrix matrix;

    /** @param change a change that has no structure. */
    Chains(const double above,
           const double below,
           const bool   are_copies,
           const double change)
    {
      const IndexSet         all = complete_index_set(2 * n);
      DynamicSparsityPattern pattern(2 * n, 2 * n);
      for (unsigned int i = 0; i < 2 * n; ++i)
        for (unsigned int j = 0; j < 2 * n; ++j)
          if (j == i || j == i + 1 || j + 1 == i || j == i + n || j + n == i)
            pattern.add(i, j);
      matrix.reinit(all, pattern, MPI_COMM_SELF);
      for (unsigned int i = 0; i < 2 * n; ++i)
        for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
          {
            const unsigned int j    = entry->column();
            const bool         same = (i / n == j / n);
            const double       step =
              (are_copies || i < n ? 1 : std::sqrt(2.)) * (i % n + 1);
            const double value = (i == j       ? step
                                  : !same      ? 0
                                  : j == i + 1 ? above
                                               : below);
            entry->value()     = value + change * std::sin(3 * i + 7 * j);
          }
    }

    Multiply
    multiply() const
    {
      return [&](LA::Vector &product, const LA::Vector &x) {
        matrix.vmult(product, x);
      };
    }
  };


  /** The eigenvalues closest to zero of A x = lambda B x or of the transposed
   * problem, B being diagonal. */
  std::vector<Eigenpair>
  lowest(const LA::SparseMatrix &A,
         const Multiply         &multiply_b,
         const LinearSystem      system)
  {
    ConditionalOStream no_output(std::cout, false);
    TimerOutput timer(no_output, TimerOutput::never, TimerOutput::wall_times);
    MumpsSolver solver(MPI_COMM_SELF, timer);
    solver.factorize_for_many(A, false);
    EigenvalueProblem problem;
    problem.symmetric = false;
    problem.multiply  = multiply_b;
    problem.solve     = [&](LA::Vector &x, const LA::Vector &b) {
      return solver.solve_system(system, x, b, 1e-12).success;
    };
    LA::Vector start(complete_index_set(2 * n), MPI_COMM_SELF);
    for (unsigned int i = 0; i < 2 * n; ++i)
      start(i) = 1 + 0.1 * std::sin(5 * i * i);
    start.compress(VectorOperation::insert);
    auto found = nearest_eigenpairs(problem, 8, start);
    if (!found.success)
      std::cout << "FAILED: " << found.message << std::endl;
    std::stable_sort(
      found.pairs.begin(), found.pairs.end(), [](const auto &a, const auto &b) {
        return std::abs(a.value) < std::abs(b.value);
      });
    return found.pairs;
  }


  void
  test(const std::string &title,
       const double       above,
       const double       below,
       const bool         are_copies)
  {
    const Multiply multiply_b = [](LA::Vector &product, const LA::Vector &x) {
      for (unsigned int i = 0; i < 2 * n; ++i)
        product(i) = (1 + 0.1 * (i % n)) * x(i);
      product.compress(VectorOperation::insert);
    };

    const Chains   chains(above, below, are_copies, 0);
    BothEigenpairs pairs;
    pairs.right = lowest(chains.matrix, multiply_b, LinearSystem::original);
    pairs.left  = left_eigenpairs(
      pairs.right,
      lowest(chains.matrix, multiply_b, LinearSystem::transposed),
      [&](const Eigenpair &x) { return product(multiply_b, x); });

    std::array<double, 2> errors{};
    for (unsigned int i = 0; i < 2; ++i)
      {
        const Chains changed(above, below, are_copies, 2e-4 / (1 + i));
        const auto   predicted =
          rayleigh_quotients(changed.multiply(), multiply_b, pairs);
        const auto exact =
          lowest(changed.matrix, multiply_b, LinearSystem::original);
        // the sum of a double pair is that of four conjugate values at most
        std::complex<double> sum = 0;
        for (unsigned int k = 0; k < 4; ++k)
          sum += predicted[k] * predicted[k] - exact[k].value * exact[k].value;
        errors[i] = std::abs(sum);
      }
    std::cout << title << ": "
              << (pairs.right[0].value.imag() != 0 ? "complex" : "real")
              << std::endl;
    check_range("  order", std::log2(errors[0] / errors[1]), 1.9, 2.1);
  }


  void
  test_defective()
  {
    // the first two unknowns of the first chain are a Jordan block
    Chains chains(0, 0, false, 0);
    for (unsigned int i = 0; i < 2; ++i)
      for (auto entry = chains.matrix.begin(i); entry != chains.matrix.end(i);
           ++entry)
        entry->value() =
          (entry->column() == i || entry->column() == i + 1 ? 1 : 0);
    for (auto entry = chains.matrix.begin(1); entry != chains.matrix.end(1);
         ++entry)
      if (entry->column() == 2)
        entry->value() = 0;
    const Multiply multiply_b = [](LA::Vector &product, const LA::Vector &x) {
      product = x;
    };
    const auto right =
      lowest(chains.matrix, multiply_b, LinearSystem::original);
    const auto left = left_eigenpairs(
      right,
      lowest(chains.matrix, multiply_b, LinearSystem::transposed),
      [](const Eigenpair &x) { return x; });
    unsigned int n_missing = 0;
    for (const Eigenpair &pair : left)
      n_missing += (pair.vector.size() == 0);
    std::cout << "defective: " << n_missing << " left eigenvectors are missing"
              << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test("single", 0.9, 0.2, false);
  test("double", 0.9, 0.2, true);
  test("single pairs", 0.9, -0.9, false);
  test("double pairs", 0.9, -0.9, true);
  test_defective();
}
