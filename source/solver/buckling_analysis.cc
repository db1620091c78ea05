// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/equations/symmetry.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/state/loads.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/solver/linear/deflation.h>
#include <biface/solver/low_rank_stiffness.h>

namespace Biface
{
  using namespace dealii;

  /** The matrices @f$\mathbf K_0-s\,\mathbf G@f$, with the parts of low rank
   * beside them. */
  struct BucklingAnalysis::Pencil
  {
    LA::SparseMatrix K_0, K_1, G;
    LowRankStiffness low_rank_0, low_rank_1;
    /** The last matrix that was factorized, and its shift. */
    LA::SparseMatrix shifted;
    LowRankStiffness low_rank_shifted;
    /** Likewise for the transposed matrix, if it is wanted. */
    LowRankStiffness low_rank_transposed;
    double           shift = 0;
    /** Keeps the shapes free of the motions that nothing holds, for the last
     * matrix that was factorized and for the transposed one. */
    std::optional<Deflation> deflation, deflation_transposed;
    /** Those of these motions that the matrices do not resist at all. */
    NullSpace null_space;
    /** The stiffness that multiply_metric() gives them. */
    double null_stiffness = 0;
    /** Whether the matrices are symmetric, and with the parts of low rank. */
    bool symmetric_matrices = true, symmetric = true;
    /** Whether @f$\mathbf K_0@f$ is symmetric positive definite. */
    bool definite = false;

    void
    multiply_K_0(LA::Vector &product, const LA::Vector &x) const
    {
      K_0.vmult(product, x);
      low_rank_0.vmult_add(product, x);
    }

    /** The product in which shapes are orthogonal: with @f$\mathbf K_0@f$,
     * and positive for the null space, too, so that it does not grow from
     * round-off. */
    void
    multiply_metric(LA::Vector &product, const LA::Vector &x) const
    {
      multiply_K_0(product, x);
      for (const LA::Vector &vector : null_space.get_vectors())
        product.add((vector * x) * null_stiffness, vector);
    }

    void
    multiply_G(LA::Vector        &product,
               const LA::Vector  &x,
               const LinearSystem system = LinearSystem::original) const
    {
      SystemMatrix{G, system}.vmult(product, x);
      if (system == LinearSystem::original)
        {
          low_rank_0.vmult_add(product, x);
          low_rank_1.vmult_add(product, x, -1);
        }
      else
        {
          low_rank_0.Tvmult_add(product, x);
          low_rank_1.Tvmult_add(product, x, -1);
        }
    }
  };


  BucklingAnalysis::BucklingAnalysis(ShellEquations           &equations,
                                     const ContactInteraction &contact,
                                     LinearSolver             &linear_solver,
                                     TimerOutput              &timer)
    : equations(equations)
    , linear_solver(linear_solver)
    , timer(timer)
    , tangent(equations, contact, timer)
    , start(arbitrary_displacements(equations.mesh, 0))
  {
    // enough for shapes of the same load
    constexpr unsigned int n_arbitrary = 6;

    const ShellMesh &mesh = equations.mesh;
    for (const std::vector<double> &motion : rigid_motions(mesh))
      {
        LA::Vector field = mesh.owned_vector();
        std::copy(motion.begin(), motion.end(), field.begin());
        fields.push_back(field);
      }
    for (unsigned int seed = 1; seed <= n_arbitrary; ++seed)
      fields.push_back(arbitrary_displacements(mesh, seed));
    for (LA::Vector &field : fields)
      field /= field.l2_norm();
  }


  void
  BucklingAnalysis::assemble(const Equilibrium &before,
                             const Equilibrium &now,
                             Pencil            &pencil)
  {
    // both tangents in the shape at the end, section 9 of doc/theory.md: then
    // they are linear in resultants and loads
    State later   = equations.internal_forces().in_shape_of_tangent(now.state);
    State earlier = later;
    earlier.resultants = before.state.resultants;
    tangent.assemble(earlier, before.loads, pencil.K_0);
    tangent.assemble(later, now.loads, pencil.K_1);
    for (LA::SparseMatrix *K : {&pencil.K_0, &pencil.K_1})
      tangent.add_contact_stiffness(now.state, now.loads, *K);
    pencil.G.copy_from(pencil.K_0);
    pencil.G.add(-1., pencil.K_1);
    // a shift must not change the sign of arbitrary entries of the diagonal
    for (const auto i : equations.mesh.locally_owned)
      if (equations.mesh.constraints.is_constrained(i))
        pencil.G.set(i, i, 0.);
    pencil.G.compress(VectorOperation::insert);

    pencil.symmetric_matrices =
      tangent.is_symmetric(before.loads, pencil.K_0) &&
      tangent.is_symmetric(now.loads, pencil.K_1);
    // in the same shape, the pressure before belongs to another amount of gas
    const auto low_rank = [&](const Loads &loads) {
      return LowRankStiffness(
        equations, later, FixedContactTangent::without_bodies(loads));
    };
    pencil.low_rank_0 = low_rank(before.loads);
    pencil.low_rank_1 = low_rank(now.loads);
    pencil.symmetric =
      pencil.symmetric_matrices && pencil.low_rank_0.is_symmetric();
    // interpolation in a curved shell resists some
    std::vector<LA::Vector> motions, unresisted;
    const auto              resists = [&](const LA::SparseMatrix &K,
                             const LA::Vector       &motion) {
      LA::Vector forces(motion);
      K.vmult(forces, motion);
      return std::abs(forces * motion) > roundoff(equations.mesh, K, motion);
    };
    for (const RigidMotion &motion : tangent.free_motions(now.state, now.loads))
      (pencil.symmetric_matrices && !resists(pencil.K_0, motion.displacement) &&
           !resists(pencil.K_1, motion.displacement)
         ? unresisted
         : motions)
        .push_back(motion.displacement);
    pencil.null_space     = NullSpace(unresisted);
    pencil.null_stiffness = pencil.K_0.linfty_norm();
    for (LA::Vector &motion : motions)
      pencil.null_space.remove_from(motion);
    if (!motions.empty())
      pencil.deflation.emplace(
        motions, [](LA::Vector &product, const LA::Vector &x) { product = x; });
  }


  namespace
  {
    // what an iterative solver may leave, relative to the right hand side
    constexpr double exactness = 1e-12;
  } // namespace


  LinearSolverResult
  BucklingAnalysis::factorize(Pencil &pencil, const double shift)
  {
    pencil.shift = shift;
    pencil.shifted.copy_from(pencil.K_0);
    pencil.shifted.add(-shift, pencil.G);
    pencil.null_space.pin(pencil.shifted);
    LinearSolverResult result = linear_solver.factorize_for_many(
      pencil.shifted, pencil.symmetric_matrices);
    if (!result.success)
      return result;
    LinearSolverResult last = result;
    const auto         fail = [&](const std::string &why) {
      if (last.success)
        last.message = why;
      last.success = false;
      return last;
    };
    const auto solve_matrix = [&](LA::Vector &x, const LA::Vector &b) {
      last = solve_pinned(pencil, x, b, LinearSystem::original);
      return last.success;
    };
    // the gas and free motions come after the factors of the matrix alone, in
    // this order, as they enter the counts of negative eigenvalues
    pencil.low_rank_shifted = pencil.low_rank_0;
    pencil.low_rank_shifted.sadd(1 - shift, shift, pencil.low_rank_1);
    if (!pencil.low_rank_shifted.prepare(solve_matrix))
      return fail("the tangent with the gas is singular");
    if (result.n_negative_pivots)
      result.n_negative_pivots =
        pencil.low_rank_shifted.n_negative(*result.n_negative_pivots);
    if (pencil.deflation)
      {
        if (!pencil.deflation->prepare([&](LA::Vector &x, const LA::Vector &b) {
              if (!solve_matrix(x, b))
                return false;
              pencil.low_rank_shifted.correct(x);
              return true;
            }))
          return fail("the tangent is singular");
        if (result.n_negative_pivots)
          result.n_negative_pivots =
            pencil.deflation->n_negative(*result.n_negative_pivots);
      }
    return result;
  }


  LinearSolverResult
  BucklingAnalysis::solve_pinned(const Pencil      &pencil,
                                 LA::Vector        &x,
                                 const LA::Vector  &b,
                                 const LinearSystem system)
  {
    LA::Vector rhs(b);
    pencil.null_space.remove_from(rhs);
    const LinearSolverResult result =
      linear_solver.solve_system(system, x, rhs, exactness);
    pencil.null_space.remove_from(x);
    return result;
  }


  bool
  BucklingAnalysis::solve(const Pencil      &pencil,
                          LA::Vector        &x,
                          const LA::Vector  &b,
                          const LinearSystem system)
  {
    const bool  original = (system == LinearSystem::original);
    const auto &low_rank =
      (original ? pencil.low_rank_shifted : pencil.low_rank_transposed);
    const auto &deflation =
      (original ? pencil.deflation : pencil.deflation_transposed);
    const auto solve = [&](LA::Vector &x, const LA::Vector &b) {
      if (!solve_pinned(pencil, x, b, system).success)
        return false;
      low_rank.correct(x);
      return true;
    };
    return deflation ? deflation->solve(x, b, solve) : solve(x, b);
  }


  std::optional<double>
  BucklingAnalysis::estimate_lowest(Pencil &pencil, BucklingModes &result)
  {
    const LinearSolverResult linear = factorize(pencil, 0);
    if (!linear.success)
      {
        result.message = linear.message;
        return {};
      }
    // then the vectors are orthogonal in the product with K_0, and Lanczos'
    // method works though G is indefinite
    pencil.definite = pencil.symmetric && linear.n_negative_pivots == 0u;

    // G x = (1/s) K_0 x
    EigenvalueProblem problem;
    problem.symmetric = pencil.definite;
    problem.wanted    = EigenvalueProblem::Wanted::next_above;
    problem.tolerance = 1e-3;
    LA::Vector between(start);
    problem.multiply = [&](LA::Vector &product, const LA::Vector &x) {
      if (pencil.definite)
        pencil.multiply_metric(product, x);
      else
        product = x;
    };
    problem.solve = [&](LA::Vector &x, const LA::Vector &b) {
      if (pencil.definite)
        {
          if (!solve(pencil, x, b))
            return false;
          pencil.multiply_G(between, x);
        }
      else
        pencil.multiply_G(between, b);
      return solve(pencil, x, between);
    };
    // complex ones may come first
    const unsigned int n          = (pencil.definite ? 1 : 6);
    Eigenpairs         eigenpairs = nearest_eigenpairs(problem, n, start);
    result.success                = eigenpairs.success;
    result.message                = eigenpairs.message;
    keep_buckling(pencil, eigenpairs.pairs);
    std::optional<double> lowest;
    for (const Eigenpair &pair : eigenpairs.pairs)
      lowest = std::min(lowest.value_or(pair.value.real()), pair.value.real());
    return lowest;
  }


  Eigenpairs
  BucklingAnalysis::find_above_shift(Pencil            &pencil,
                                     const unsigned int n,
                                     const LinearSystem system)
  {
    Assert(!pencil.definite || system == LinearSystem::original,
           ExcInternalError());
    EigenvalueProblem problem;
    problem.symmetric = pencil.definite;
    problem.wanted    = EigenvalueProblem::Wanted::next_above;
    LA::Vector between(start);
    if (pencil.definite)
      {
        // (K_0 - sigma G)^-1 K_0 has the eigenvalues s/(s - sigma)
        problem.multiply = [&](LA::Vector &product, const LA::Vector &x) {
          pencil.multiply_metric(product, x);
        };
        problem.solve = [&](LA::Vector &x, const LA::Vector &b) {
          return solve(pencil, x, b);
        };
      }
    else
      {
        // (K_0 - sigma G)^-1 G has the eigenvalues 1/(s - sigma)
        problem.shift    = pencil.shift;
        problem.multiply = [&](LA::Vector &product, const LA::Vector &x) {
          product = x;
        };
        problem.solve = [&](LA::Vector &x, const LA::Vector &b) {
          pencil.multiply_G(between, b, system);
          return solve(pencil, x, between, system);
        };
      }
    Eigenpairs found = nearest_eigenpairs(problem, n, start);
    if (pencil.definite)
      for (Eigenpair &pair : found.pairs)
        pair.value = pencil.shift / (1. - pair.value);
    return found;
  }


  std::vector<Eigenpair>
  BucklingAnalysis::find_left(Pencil                       &pencil,
                              const std::vector<Eigenpair> &right,
                              const unsigned int            n)
  {
    pencil.low_rank_transposed = pencil.low_rank_shifted.transposed();
    // the factors remain; what surrounds them changes in the transposed problem
    if (!pencil.low_rank_transposed.prepare(
          [&](LA::Vector &x, const LA::Vector &b) {
            return solve_pinned(pencil, x, b, LinearSystem::transposed).success;
          }))
      return std::vector<Eigenpair>(right.size());
    if (pencil.deflation)
      {
        Deflation transposed = *pencil.deflation;
        if (!transposed.prepare([&](LA::Vector &x, const LA::Vector &b) {
              return solve(pencil, x, b, LinearSystem::transposed);
            }))
          return std::vector<Eigenpair>(right.size());
        pencil.deflation_transposed = transposed;
      }
    return left_eigenpairs(
      right,
      find_above_shift(pencil, n, LinearSystem::transposed).pairs,
      [&](const Eigenpair &x) {
        return product(
          [&](LA::Vector &product, const LA::Vector &x) {
            pencil.multiply_G(product, x);
          },
          x);
      });
  }


  void
  BucklingAnalysis::keep_buckling(const Pencil           &pencil,
                                  std::vector<Eigenpair> &pairs) const
  {
    for (Eigenpair &pair : pairs)
      make_real(pair);
    // the others belong to reversed loads, or to oscillations of tangents that
    // are not symmetric
    pairs.erase(std::remove_if(pairs.begin(),
                               pairs.end(),
                               [&](const Eigenpair &pair) {
                                 return !(pair.value.real() > 0) ||
                                        pair.value.imag() != 0 ||
                                        !is_softened(pencil, pair.vector);
                               }),
                pairs.end());
  }


  bool
  BucklingAnalysis::is_softened(const Pencil     &pencil,
                                const LA::Vector &shape) const
  {
    LA::Vector product(shape);
    pencil.multiply_G(product, shape);
    return std::abs(product * shape) >
           roundoff(equations.mesh, pencil.K_0, shape) +
             roundoff(equations.mesh, pencil.K_1, shape);
  }


  BucklingModes
  BucklingAnalysis::compute(const Equilibrium &before,
                            const Equilibrium &now,
                            const LoadRates   &rates,
                            const unsigned int n,
                            const bool         with_left)
  {
    TimerOutput::Scope scope(timer, "Buckling");

    const ShellMesh &mesh = equations.mesh;
    BucklingModes    result;
    Pencil           pencil;
    assemble(before, now, pencil);
    for (const RigidMotion &motion : tangent.free_motions(now.state, now.loads))
      result.free_motions.push_back(motion.name);
    const std::optional<double> lowest = estimate_lowest(pencil, result);
    if (!lowest)
      return result;
    result.success = false;

    // below the lowest position, of which only an estimate is known; closer, if
    // a matrix happens to be singular
    constexpr double   below = 0.9, lower = 0.7;
    constexpr unsigned max_attempts = 12;
    const unsigned int n_computed =
      std::max(n, std::min<unsigned int>(n + 4, mesh.n_unknowns() / 4));
    LinearSolverResult linear;
    double             shift = below * *lowest;
    // by Sylvester's law of inertia, the negative pivots count the positions
    // below the shift: there must be none
    for (unsigned int attempt = 0; attempt < max_attempts; ++attempt)
      {
        linear = factorize(pencil, shift);
        if (linear.success &&
            !(pencil.definite && linear.n_negative_pivots > 0u))
          break;
        shift *= lower;
      }
    if (!linear.success)
      {
        result.message = linear.message;
        return result;
      }
    Eigenpairs eigenpairs = find_above_shift(pencil, n_computed);
    result.success        = eigenpairs.success;
    result.message        = eigenpairs.message;
    if (!result.success)
      return result;

    std::vector<Eigenpair> &pairs = eigenpairs.pairs;
    keep_buckling(pencil, pairs);
    settle(
      pairs,
      [&](LA::Vector &product, const LA::Vector &x) {
        if (pencil.definite)
          pencil.multiply_K_0(product, x);
        else
          product = x;
      },
      fields);

    std::vector<Eigenpair> left(pairs.size());
    if (with_left)
      left = (pencil.symmetric ? pairs : find_left(pencil, pairs, n_computed));

    const LA::Vector loads = equations.load_direction(
      equations.internal_forces().in_shape_of_tangent(now.state),
      now.loads,
      rates);
    for (unsigned int i = 0; i < pairs.size() && i < n; ++i)
      {
        result.modes.push_back(finish(pairs[i].vector, loads));
        result.modes[i].position = pairs[i].value.real();
        result.modes[i].left     = left[i];
      }
    return result;
  }


  std::vector<double>
  BucklingAnalysis::quotients(const Equilibrium               &before,
                              const Equilibrium               &now,
                              const std::vector<BucklingMode> &modes)
  {
    Pencil pencil;
    assemble(before, now, pencil);
    BothEigenpairs neighbors;
    for (const BucklingMode &mode : modes)
      {
        neighbors.right.push_back({mode.position, owned_part(mode.shape), {}});
        equations.mesh.constraints.set_zero(neighbors.right.back().vector);
        neighbors.left.push_back(mode.left);
      }
    std::vector<double> positions;
    for (const std::complex<double> &position : rayleigh_quotients(
           [&](LA::Vector &product, const LA::Vector &x) {
             pencil.multiply_K_0(product, x);
           },
           [&](LA::Vector &product, const LA::Vector &x) {
             pencil.multiply_G(product, x);
           },
           neighbors))
      positions.push_back(position.real());
    return positions;
  }


  BucklingMode
  BucklingAnalysis::finish(const LA::Vector &vector,
                           const LA::Vector &loads) const
  {
    BucklingMode mode;
    mode.shape             = normalized_shapes(equations.mesh, {vector})[0];
    const double all_loads = loads.l1_norm();
    if (all_loads > 0)
      mode.load_work = std::abs(loads * owned_part(mode.shape)) / all_loads;
    mode.waves = wave_numbers(equations.mesh, {mode.shape});
    return mode;
  }


  bool
  BucklingAnalysis::assemble(const Equilibrium &now, LA::SparseMatrix &K)
  {
    tangent.assemble(now.state, now.loads, K);
    tangent.add_contact_stiffness(now.state, now.loads, K);
    return tangent.is_symmetric(now.loads, K);
  }


  std::optional<unsigned int>
  BucklingAnalysis::count_negative_pivots(const Equilibrium &now,
                                          const bool         often)
  {
    LA::SparseMatrix K;
    if (!assemble(now, K) && !tangent.is_symmetric_but_for_loads(now.loads))
      return {};
    return linear_solver.count_negative_pivots(K, often);
  }


  double
  BucklingAnalysis::softening(const Equilibrium &now, const LA::Vector &shape)
  {
    State unloaded = now.state;
    for (Modes::Vector &H : unloaded.resultants)
      H = Modes::Vector();
    Loads none    = now.loads;
    none.pressure = 0;
    none.factors.assign(none.factors.size(), 0);
    LA::SparseMatrix K;
    tangent.assemble(unloaded, none, K);
    tangent.add_contact_stiffness(now.state, now.loads, K);
    LA::Vector product(shape);
    K.vmult(product, shape);
    return product * shape / shape.norm_sqr();
  }


  std::optional<BucklingAnalysis::CriticalMode>
  BucklingAnalysis::critical_mode(const Equilibrium &now,
                                  const LoadRates   &rates,
                                  const bool         unstable)
  {
    // parts of the loads and of the size of an eigenvalue
    constexpr double tolerance = 0.01, real = 1e-8;

    LA::SparseMatrix  K;
    EigenvalueProblem problem;
    problem.symmetric = assemble(now, K);
    problem.tolerance = 1e-8;
    if (!linear_solver.factorize_for_many(K, problem.symmetric).success)
      return {};
    problem.multiply = [&](LA::Vector &product, const LA::Vector &x) {
      product = x;
    };
    problem.solve = [&](LA::Vector &x, const LA::Vector &b) {
      return linear_solver.solve(x, b, exactness).success;
    };
    // some of them may have the wrong sign
    Eigenpairs found = nearest_eigenpairs(problem, n_candidates, start);
    if (!found.success || found.pairs.empty())
      return {};
    const auto rank = [&](const Eigenpair &pair) {
      return std::make_pair((pair.value.real() < 0) != unstable,
                            std::abs(pair.value));
    };
    settle(found.pairs, problem.multiply, fields);
    const auto critical = std::min_element(
      found.pairs.begin(),
      found.pairs.end(),
      [&](const auto &a, const auto &b) { return rank(a) < rank(b); });
    CriticalMode result{
      finish(critical->vector,
             equations.load_direction(now.state, now.loads, rates)),
      true};
    const std::complex<double> value = critical->value;
    if (!problem.symmetric)
      result.is_of_tangent =
        (std::abs(value.imag()) <= real * std::abs(value.real()) &&
         (value.real() < 0) == unstable) ||
        std::abs(value) <= tolerance * softening(now, critical->vector);
    return result;
  }
} // namespace Biface
