// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/solver/low_rank_stiffness.h>

namespace Biface
{
  using namespace dealii;

  LowRankStiffness::LowRankStiffness(const EquationSystem &equations,
                                     const State          &state,
                                     const Loads          &loads)
  {
    for (const auto &[forces, gradient] : equations.low_rank_part(state, loads))
      {
        parts.push_back({forces, gradient, gradient, {}});
        equations.mesh.condense(parts.back().gradient);
        if (parts.back().gradient.linfty_norm() == 0)
          parts.pop_back();
      }
  }


  bool
  LowRankStiffness::is_symmetric() const
  {
    constexpr double parallel = 1e-8;

    return std::all_of(parts.begin(), parts.end(), [](const Part &part) {
      LA::Vector difference(part.forces);
      difference.add(-part.proportion(), part.gradient);
      return difference.l2_norm() <= parallel * part.forces.l2_norm();
    });
  }


  void
  LowRankStiffness::vmult_add(LA::Vector       &product,
                              const LA::Vector &x,
                              const double      factor) const
  {
    for (const Part &part : parts)
      product.add(-factor * (part.gradient * x), part.forces);
  }


  void
  LowRankStiffness::Tvmult_add(LA::Vector       &product,
                               const LA::Vector &x,
                               const double      factor) const
  {
    for (const Part &part : parts)
      product.add(-factor * (part.forces * x), part.gradient);
  }


  void
  LowRankStiffness::sadd(const double            s,
                         const double            a,
                         const LowRankStiffness &other)
  {
    AssertDimension(parts.size(), other.parts.size());
    for (unsigned int i = 0; i < parts.size(); ++i)
      parts[i].gradient.sadd(s, a, other.parts[i].gradient);
  }


  LowRankStiffness
  LowRankStiffness::transposed() const
  {
    LowRankStiffness result = *this;
    for (Part &part : result.parts)
      std::swap(part.forces, part.gradient);
    return result;
  }


  bool
  LowRankStiffness::prepare(const Solve &solve)
  {
    const unsigned int rank = parts.size();
    if (rank == 0)
      return true;
    for (Part &part : parts)
      {
        part.solution.reinit(part.forces);
        if (!solve(part.solution, part.forces))
          return false;
      }
    // the Woodbury formula: a small system in place of other factors
    LAPACKFullMatrix<double> matrix(rank);
    for (unsigned int i = 0; i < rank; ++i)
      for (unsigned int j = 0; j < rank; ++j)
        {
          matrix(i, j) =
            (i == j ? 1. : 0.) - parts[i].gradient * parts[j].solution;
          if (!std::isfinite(matrix(i, j)))
            return false;
        }
    try
      {
        matrix.invert();
      }
    catch (const LACExceptions::ExcSingular &)
      {
        return false;
      }
    inverse.reinit(rank, rank);
    inverse = matrix;
    return true;
  }


  void
  LowRankStiffness::correct(LA::Vector &x, const LA::Vector *supports) const
  {
    Vector<double> changes(parts.size()), factors(parts.size());
    for (unsigned int i = 0; i < parts.size(); ++i)
      changes[i] =
        parts[i].gradient * x +
        (supports ? parts[i].gradient_with_supports * *supports : 0.);
    if (!parts.empty())
      inverse.vmult(factors, changes);
    for (unsigned int i = 0; i < parts.size(); ++i)
      x.add(factors[i], parts[i].solution);
  }


  void
  LowRankStiffness::complete(
    LA::Vector &x, const EquationSystem::ParameterDirection &direction) const
  {
    if (!direction.supports)
      {
        correct(x);
        return;
      }
    correct(x, &*direction.supports);
    x += *direction.supports;
  }


  std::optional<unsigned int>
  LowRankStiffness::n_negative(const unsigned int of_matrix) const
  {
    const unsigned int rank = parts.size();
    if (rank == 0)
      return of_matrix;
    if (inverse.empty() || !is_symmetric())
      return {};
    // With F = G D, the sum K - G D G^T has the negative eigenvalues of K and
    // of 1/D - G^T K^-1 G, less those of 1/D. The inverse of the second one has
    // the same signs.
    LAPACKFullMatrix<double> between(rank);
    int                      n = of_matrix;
    for (unsigned int i = 0; i < rank; ++i)
      {
        const double d = parts[i].proportion();
        if (d < 0)
          --n;
        for (unsigned int j = 0; j < rank; ++j)
          between(i, j) = d * inverse(i, j);
      }
    between.compute_eigenvalues();
    for (unsigned int i = 0; i < rank; ++i)
      if (between.eigenvalue(i).real() < 0)
        ++n;
    return std::max(n, 0);
  }
} // namespace Biface
