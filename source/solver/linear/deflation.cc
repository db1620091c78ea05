// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

#include <biface/solver/linear/deflation.h>

namespace Biface
{
  using namespace dealii;

  Deflation::Deflation(const std::vector<LA::Vector>                  &given,
                       const std::function<void(LA::Vector       &product,
                                                const LA::Vector &x)> &multiply)
    : vectors(given)
    , products(given)
    , matrix(given.size(), given.size())
    , inverse(given.size(), given.size())
  {
    for (unsigned int i = 0; i < vectors.size(); ++i)
      {
        // twice is enough
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (unsigned int j = 0; j < i; ++j)
            vectors[i].add(-(products[j] * vectors[i]), vectors[j]);
        multiply(products[i], vectors[i]);
        const double norm = std::sqrt(products[i] * vectors[i]);
        vectors[i] /= norm;
        products[i] /= norm;
      }
  }


  bool
  Deflation::prepare(const Solve &solve)
  {
    const unsigned int n = vectors.size();
    solutions            = vectors;
    for (unsigned int i = 0; i < n; ++i)
      {
        solutions[i] = 0;
        if (!solve(solutions[i], products[i]))
          return false;
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        matrix(i, j) = products[i] * solutions[j];
    inverse = matrix;
    return n == 0 || invert(inverse);
  }


  bool
  Deflation::solve(LA::Vector &x, const LA::Vector &b, const Solve &solve) const
  {
    if (vectors.empty())
      return solve(x, b);
    // a part of the solution that the multipliers take away, but only up to
    // round-off if it is large
    LA::Vector rhs(b);
    for (unsigned int i = 0; i < vectors.size(); ++i)
      rhs.add(-(vectors[i] * b), products[i]);
    if (!solve(x, rhs))
      return false;
    Vector<double> parts(vectors.size()), multipliers(vectors.size());
    for (unsigned int i = 0; i < vectors.size(); ++i)
      parts[i] = products[i] * x;
    inverse.vmult(multipliers, parts);
    for (unsigned int i = 0; i < vectors.size(); ++i)
      x.add(-multipliers[i], solutions[i]);
    return true;
  }


  unsigned int
  Deflation::n_negative(const unsigned int of_matrix) const
  {
    // by the inertia of the matrix with the multipliers
    if (vectors.empty())
      return of_matrix;
    LAPACKFullMatrix<double> symmetric(vectors.size());
    for (unsigned int i = 0; i < vectors.size(); ++i)
      for (unsigned int j = 0; j < vectors.size(); ++j)
        symmetric(i, j) = (matrix(i, j) + matrix(j, i)) / 2;
    symmetric.compute_eigenvalues();
    unsigned int n = 0;
    for (unsigned int i = 0; i < vectors.size(); ++i)
      if (symmetric.eigenvalue(i).real() < 0)
        ++n;
    return of_matrix - std::min(of_matrix, n);
  }


  NullSpace::NullSpace(const std::vector<LA::Vector> &given) : vectors(given)
  {
    if (vectors.empty())
      return;
    const MPI_Comm communicator = vectors[0].get_mpi_communicator();

    // by Gaussian elimination, each vector for its largest entry
    std::vector<LA::Vector> rows = vectors;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        double                  largest = -1;
        types::global_dof_index index   = 0;
        for (const auto k : rows[i].locally_owned_elements())
          if (const double entry = rows[i](k); std::abs(entry) > largest)
            {
              largest = std::abs(entry);
              index   = k;
            }
        const unsigned int owner =
          Utilities::MPI::min_max_avg(largest, communicator).max_index;
        index = Utilities::MPI::broadcast(communicator, index, owner);
        pinned.push_back(index);
        std::vector<double> entries(rows.size());
        if (rows[i].in_local_range(index))
          for (unsigned int j = i; j < rows.size(); ++j)
            entries[j] = rows[j](index);
        entries = Utilities::MPI::broadcast(communicator, entries, owner);
        for (unsigned int j = i + 1; j < rows.size(); ++j)
          rows[j].add(-entries[j] / entries[i], rows[i]);
      }

    // orthonormal, to remove the part of a vector by scalar products
    for (unsigned int i = 0; i < vectors.size(); ++i)
      {
        // twice is enough
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (unsigned int j = 0; j < i; ++j)
            vectors[i].add(-(vectors[j] * vectors[i]), vectors[j]);
        vectors[i] /= vectors[i].l2_norm();
      }
  }


  void
  NullSpace::pin(LA::SparseMatrix &A) const
  {
    for (const auto index : pinned)
      if (A.in_local_range(index))
        A.add(index, index, A.diag_element(index));
    A.compress(VectorOperation::add);
  }


  void
  NullSpace::remove_from(LA::Vector &x) const
  {
    for (const LA::Vector &vector : vectors)
      x.add(-(vector * x), vector);
  }
} // namespace Biface
