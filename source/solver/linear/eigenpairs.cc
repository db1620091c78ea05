// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/parpack_solver.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/solver/linear/eigenpairs.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A linear system was not solved. */
    struct NotSolved
    {};

    /** The vectors of ARPACK, which fails on ranks without entries: if there
     * are such ranks, all have about the same number of entries. */
    class ArpackLayout
    {
    public:
      /** @param like a vector of the problem, kept by reference. */
      explicit ArpackLayout(const LA::Vector &like)
        : like(like)
        , differs(Utilities::MPI::min(like.locally_owned_size(),
                                      like.get_mpi_communicator()) == 0)
      {}

      /** A vector of ARPACK. */
      LA::Vector
      spread(const LA::Vector &x) const
      {
        if (!differs)
          return x;
        const MPI_Comm communicator = like.get_mpi_communicator();
        const auto parts = Utilities::create_evenly_distributed_partitioning(
          Utilities::MPI::this_mpi_process(communicator),
          Utilities::MPI::n_mpi_processes(communicator),
          like.size());
        LA::Vector result(parts, communicator);
        result.reinit(x, false, true);
        return result;
      }

      /** A vector of the problem. */
      LA::Vector
      gathered(const LA::Vector &x) const
      {
        if (!differs)
          return x;
        LA::Vector result(like);
        result.reinit(x, false, true);
        return result;
      }

      /** Let a function of vectors of the problem act on those of ARPACK. */
      template <typename Function>
      void
      apply(const Function   &function,
            LA::Vector       &result,
            const LA::Vector &x) const
      {
        if (!differs)
          return function(result, x);
        LA::Vector own(like);
        function(own, gathered(x));
        result.reinit(own, false, true);
      }

    private:
      const LA::Vector &like;
      const bool        differs;
    };

    struct Product
    {
      const ArpackLayout &layout;
      const Multiply     &multiply;

      void
      vmult(LA::Vector &product, const LA::Vector &x) const
      {
        layout.apply(multiply, product, x);
      }
    };

    struct Inverse
    {
      const ArpackLayout                                            &layout;
      const std::function<bool(LA::Vector &x, const LA::Vector &b)> &solve;

      void
      vmult(LA::Vector &x, const LA::Vector &b) const
      {
        layout.apply(
          [this](LA::Vector &result, const LA::Vector &rhs) {
            if (!solve(result, rhs))
              throw NotSolved();
          },
          x,
          b);
      }
    };


    using Arpack = PArpackSolver<LA::Vector>;

    /** What ARPACK is asked for. */
    struct Task
    {
      Arpack::WhichEigenvalues which;
      bool                     symmetric;
      /** 1 for the eigenvalues of the product, 3 for those next to a shift. */
      int    mode;
      double shift;
      double tolerance;
    };


    /** The eigenvalues found by ARPACK, both of a complex pair. */
    Eigenpairs
    run_arpack(
      const Task                                                    &task,
      const Multiply                                                &multiply,
      const std::function<bool(LA::Vector &x, const LA::Vector &b)> &solve,
      const unsigned int                                             n,
      const LA::Vector                                              &start)
    {
      constexpr unsigned int max_restarts = 300;
      const ArpackLayout     layout(start);
      const Product          product{layout, multiply};
      const Inverse          inverse{layout, solve};
      const LA::Vector       first = layout.spread(start);

      Eigenpairs result;
      // more basis vectors make restarts rare
      const unsigned int n_basis = std::min<unsigned int>(
        std::max(2 * n + 2, std::min(2 * n + 10, 3 * n + 6)), start.size() - 1);
      if (n_basis < 2 * n + 2 || start.size() < Utilities::MPI::n_mpi_processes(
                                                  start.get_mpi_communicator()))
        {
          result.message = "the mesh has too few unknowns for this number of "
                           "modes";
          return result;
        }

      std::vector<std::complex<double>> values(n);
      std::vector<LA::Vector>           vectors(n + 1, first);
      // a failed solution leaves ARPACK by an exception; the same on all ranks
      try
        {
          SolverControl control(max_restarts, task.tolerance, false, false);
          Arpack        solver(control,
                        start.get_mpi_communicator(),
                        Arpack::AdditionalData(
                          n_basis, task.which, task.symmetric, task.mode));
          solver.reinit(first);
          solver.set_initial_vector(first);
          solver.set_shift(task.shift);
          solver.solve(product, product, inverse, values, vectors, n);
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
          pair.vector = layout.gathered(vectors[i]);
          if (values[i].imag() == 0)
            result.pairs.push_back(pair);
          else if (i + 1 < n)
            {
              // the pair shares the two vectors
              pair.imaginary = layout.gathered(vectors[i + 1]);
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
    const auto    which = (problem.wanted == EigenvalueProblem::Wanted::nearest
                             ? Arpack::largest_magnitude
                           : problem.symmetric ? Arpack::algebraically_largest
                                               : Arpack::largest_real_part);
    constexpr int shift_and_invert = 3;
    return run_arpack({which,
                       problem.symmetric,
                       shift_and_invert,
                       problem.shift,
                       problem.tolerance},
                      problem.multiply,
                      problem.solve,
                      n,
                      start);
  }


  namespace
  {
    /** Two vectors as one. */
    LA::Vector
    stacked(const LA::Vector &upper, const LA::Vector &lower)
    {
      const IndexSet &owned = upper.locally_owned_elements();
      IndexSet        twice(2 * owned.size());
      twice.add_indices(owned);
      twice.add_indices(owned, owned.size());
      twice.compress();
      LA::Vector result(twice, upper.get_mpi_communicator());
      std::copy(upper.begin(), upper.end(), result.begin());
      std::copy(
        lower.begin(), lower.end(), result.begin() + owned.n_elements());
      return result;
    }


    /** Both parts of stacked(). */
    void
    split(const LA::Vector &both, LA::Vector &upper, LA::Vector &lower)
    {
      const auto middle =
        both.begin() + upper.locally_owned_elements().n_elements();
      std::copy(both.begin(), middle, upper.begin());
      std::copy(middle, both.end(), lower.begin());
    }
  } // namespace


  Eigenpairs
  nearest_eigenpairs(const QuadraticEigenvalueProblem &problem,
                     const unsigned int                n,
                     const LA::Vector                 &start)
  {
    Eigenpairs result;

    // the magnitude of the lowest eigenvalues, by inverse iterations
    double reference = 1;
    {
      constexpr unsigned int n_iterations = 3;
      LA::Vector             x(start), product(start);
      for (unsigned int i = 0; i < n_iterations; ++i)
        {
          problem.multiply_mass(product, x);
          const double before = product * x;
          if (!problem.solve(x, product))
            {
              result.message = "the tangent is singular or nearly so";
              return result;
            }
          problem.multiply_mass(product, x);
          const double after = product * x;
          if (before > 0 && after > 0)
            reference = std::pow(before / after, 0.25);
        }
    }

    LA::Vector     x(start), w(start), force(start), part(start);
    const Multiply multiply = [&](LA::Vector &product, const LA::Vector &both) {
      split(both, x, w);
      problem.multiply_velocity(force, x);
      problem.multiply_mass(part, x);
      force.sadd(-reference, -2 * problem.shift * reference, part);
      problem.multiply_mass(part, w);
      force.add(-reference * reference, part);
      part = 0;
      if (!problem.solve(part, force))
        throw NotSolved();
      std::copy(part.begin(), part.end(), product.begin());
      std::copy(x.begin(),
                x.end(),
                product.begin() + x.locally_owned_elements().n_elements());
    };
    // each frequency is an eigenvalue twice, with both signs
    constexpr int as_it_is = 1;
    Eigenpairs    found    = run_arpack(
      {Arpack::largest_magnitude, false, as_it_is, 0, problem.tolerance},
      multiply,
      problem.solve,
      2 * n,
      stacked(start, start));
    result.success = found.success;
    result.message = found.message;

    constexpr double real = 1e-8;
    for (const Eigenpair &pair : found.pairs)
      {
        const std::complex<double> rate =
          problem.shift + reference / pair.value;
        const bool oscillates = (pair.imaginary.size() > 0);
        Eigenpair  mode;
        mode.value = {oscillates ? rate.imag() : 0., -rate.real()};
        if (std::abs(mode.value.imag()) <= real * std::abs(mode.value))
          mode.value.imag(0);
        // one of both is enough: they are the same motion
        if (mode.value.real() < 0 ||
            (!oscillates && problem.conservative && mode.value.imag() > 0))
          continue;
        mode.vector = start;
        split(pair.vector, mode.vector, w);
        if (oscillates)
          {
            mode.imaginary = start;
            split(pair.imaginary, mode.imaginary, w);
          }
        result.pairs.push_back(mode);
      }
    std::stable_sort(result.pairs.begin(),
                     result.pairs.end(),
                     [](const auto &a, const auto &b) {
                       return std::abs(a.value) < std::abs(b.value);
                     });
    return result;
  }


  bool
  are_same(const std::complex<double> &a, const std::complex<double> &b)
  {
    constexpr double same = 1e-7;
    return std::abs(b - a) <= same * std::abs(b);
  }


  Eigenpair
  product(const Multiply &multiply, const Eigenpair &x)
  {
    Eigenpair result = x;
    multiply(result.vector, x.vector);
    if (x.imaginary.size() > 0)
      multiply(result.imaginary, x.imaginary);
    return result;
  }


  std::complex<double>
  product(const Eigenpair &y, const Eigenpair &x)
  {
    const bool           complex_x = (x.imaginary.size() > 0);
    std::complex<double> result(y.vector * x.vector,
                                complex_x ? y.vector * x.imaginary : 0);
    if (y.imaginary.size() > 0)
      result += std::complex<double>(
        complex_x ? -(y.imaginary * x.imaginary) : 0, y.imaginary * x.vector);
    return result;
  }


  Eigenpair
  combination(const std::vector<std::complex<double>> &factors,
              const std::vector<Eigenpair>            &pairs)
  {
    Eigenpair result = pairs[0];
    result.vector    = 0;
    result.imaginary = result.vector;
    for (unsigned int j = 0; j < pairs.size(); ++j)
      {
        const std::complex<double> c = factors[j];
        result.vector.add(c.real(), pairs[j].vector);
        result.imaginary.add(c.imag(), pairs[j].vector);
        if (pairs[j].imaginary.size() == 0)
          continue;
        result.vector.add(-c.imag(), pairs[j].imaginary);
        result.imaginary.add(c.real(), pairs[j].imaginary);
      }
    return result;
  }


  namespace
  {
    double
    norm(const Eigenpair &x)
    {
      return std::hypot(x.vector.l2_norm(),
                        x.imaginary.size() > 0 ? x.imaginary.l2_norm() : 0);
    }


    /** The positions of pairs with the same eigenvalue; conjugate ones may
     * alternate with each other. */
    std::vector<std::vector<unsigned int>>
    groups_of(const std::vector<Eigenpair> &pairs)
    {
      std::vector<std::vector<unsigned int>> groups;
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          const auto group =
            std::find_if(groups.rbegin(), groups.rend(), [&](const auto &g) {
              return are_same(pairs[g.back()].value, pairs[i].value);
            });
          if (group != groups.rend())
            group->push_back(i);
          else
            groups.push_back({i});
        }
      return groups;
    }


    /** Take those out of a list whose eigenvalues are closest to a given one.
     */
    std::vector<Eigenpair>
    take_closest(const std::complex<double> &value,
                 const unsigned int          n,
                 std::vector<Eigenpair>     &from)
    {
      std::vector<Eigenpair> taken;
      while (taken.size() < n && !from.empty())
        {
          const auto closest = std::min_element(
            from.begin(), from.end(), [&](const auto &a, const auto &b) {
              return std::abs(a.value - value) < std::abs(b.value - value);
            });
          taken.push_back(*closest);
          from.erase(closest);
        }
      return taken;
    }


    /** A value for each pair of a right and a left eigenvector, not a number
     * without a left one; those of the same eigenvalue are replaced by their
     * mean. */
    std::vector<std::complex<double>>
    mean_values(const BothEigenpairs                       &neighbors,
                const std::function<std::complex<double>(
                  const Eigenpair &x, const Eigenpair &y)> &value)
    {
      AssertDimension(neighbors.left.size(), neighbors.right.size());
      std::vector<std::complex<double>> values;
      for (unsigned int i = 0; i < neighbors.right.size(); ++i)
        values.push_back(neighbors.left[i].vector.size() == 0
                           ? std::numeric_limits<double>::quiet_NaN()
                           : value(neighbors.right[i], neighbors.left[i]));
      for (const auto &group : groups_of(neighbors.right))
        {
          std::complex<double> sum = 0;
          for (const unsigned int i : group)
            sum += values[i];
          for (const unsigned int i : group)
            values[i] = sum / double(group.size());
        }
      return values;
    }
  } // namespace


  void
  make_real(Eigenpair &pair)
  {
    constexpr double real = 1e-8;
    if (!(std::abs(pair.value.imag()) <= real * std::abs(pair.value)))
      return;
    if (pair.value.imag() < 0)
      pair.vector = pair.imaginary;
    pair.value.imag(0);
    pair.imaginary.clear();
  }


  std::vector<Eigenpair>
  left_eigenpairs(
    const std::vector<Eigenpair>                      &right,
    std::vector<Eigenpair>                             found,
    const std::function<Eigenpair(const Eigenpair &)> &multiply_derivative)
  {
    // The sensitivity of an eigenvalue beyond which it counts as defective. The
    // vectors of others are orthogonal up to round-off.
    constexpr double maximum = 1e7;

    std::vector<Eigenpair> result(right.size());
    for (const auto &group : groups_of(right))
      {
        const unsigned int           n = group.size();
        const std::vector<Eigenpair> left =
          take_closest(right[group[0]].value, n, found);
        if (left.size() < n)
          break;

        // the vectors of a multiple eigenvalue are arbitrary: they are combined
        // such that each belongs to one of the right ones
        std::vector<Eigenpair>           images;
        std::vector<double>              sizes;
        FullMatrix<std::complex<double>> products(n, n), inverse(n, n);
        for (unsigned int j = 0; j < n; ++j)
          {
            images.push_back(multiply_derivative(right[group[j]]));
            sizes.push_back(norm(images[j]));
            for (unsigned int i = 0; i < n; ++i)
              products(i, j) =
                product(left[i], images[j]) / (norm(left[i]) * sizes[j]);
          }
        try
          {
            inverse.invert(products);
          }
        catch (const ExceptionBase &)
          {
            continue;
          }
        if (!(inverse.frobenius_norm() <= maximum))
          continue;
        for (unsigned int i = 0; i < n; ++i)
          {
            std::vector<std::complex<double>> factors;
            for (unsigned int j = 0; j < n; ++j)
              factors.push_back(inverse(i, j) / (sizes[i] * norm(left[j])));
            result[group[i]] = combination(factors, left);
          }
      }
    return result;
  }


  std::vector<std::complex<double>>
  rayleigh_quotients(const Multiply       &multiply_a,
                     const Multiply       &multiply_b,
                     const BothEigenpairs &neighbors)
  {
    return mean_values(neighbors, [&](const Eigenpair &x, const Eigenpair &y) {
      return product(y, product(multiply_a, x)) /
             product(y, product(multiply_b, x));
    });
  }


  std::vector<std::complex<double>>
  rayleigh_roots(const Multiply       &multiply_k,
                 const Multiply       &multiply_g,
                 const Multiply       &multiply_m,
                 const BothEigenpairs &neighbors)
  {
    const std::complex<double> i_unit(0, 1);
    return mean_values(neighbors, [&](const Eigenpair &x, const Eigenpair &y) {
      const std::complex<double> k = product(y, product(multiply_k, x));
      const std::complex<double> g =
        i_unit * product(y, product(multiply_g, x));
      const std::complex<double> m     = product(y, product(multiply_m, x));
      const std::complex<double> d     = std::sqrt(g * g + 4. * m * k);
      const std::complex<double> upper = (g + d) / (2. * m);
      const std::complex<double> lower = (g - d) / (2. * m);
      return std::abs(upper - x.value) < std::abs(lower - x.value) ? upper
                                                                   : lower;
    });
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


  void
  normalize_phases(std::vector<Eigenpair>        &pairs,
                   const Multiply                &multiply,
                   const std::vector<LA::Vector> &fields)
  {
    // the part of a field that is not round-off
    constexpr double significant = 1e-3;

    for (Eigenpair &pair : pairs)
      {
        LA::Vector &a          = pair.vector;
        LA::Vector &b          = pair.imaginary;
        const bool  is_complex = (b.size() > 0);
        LA::Vector  product(a);
        multiply(product, a);
        double square = product * a;
        if (is_complex)
          {
            multiply(product, b);
            square += product * b;
          }
        if (square <= 0)
          continue;
        std::complex<double> phase = 1;
        // the first field that tells a phase, the same on any number of ranks
        for (const LA::Vector &field : fields)
          {
            const std::complex<double> content(field * a,
                                               is_complex ? field * b : 0);
            if (std::abs(content) < significant * std::sqrt(square))
              continue;
            phase = std::conj(content) / std::abs(content);
            break;
          }
        phase /= std::sqrt(square);
        const LA::Vector old_a(a);
        a *= phase.real();
        if (is_complex)
          {
            a.add(-phase.imag(), b);
            b.sadd(phase.real(), phase.imag(), old_a);
          }
      }
  }
} // namespace Biface
