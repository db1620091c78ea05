// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <biface/contact/rolling.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/equations/symmetry.h>
#include <biface/model/equations/velocity_matrix.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/state/loads.h>
#include <biface/solver/linear/deflation.h>
#include <biface/solver/low_rank_stiffness.h>
#include <biface/solver/modal_analysis.h>
#include <biface/solver/shell_with_air.h>

namespace Biface
{
  using namespace dealii;

  double
  VibrationMode::frequency() const
  {
    return omega.real() / (2 * numbers::PI);
  }


  std::complex<double>
  omega_of(const std::complex<double> &square)
  {
    const std::complex<double> omega = std::sqrt(square);
    return square.imag() == 0 ? std::conj(omega) : omega;
  }


  double
  VibrationMode::growth_rate() const
  {
    return -omega.imag();
  }


  ModalAnalysis::ModalAnalysis(ShellEquations           &equations,
                               const ContactInteraction &contact,
                               LinearSolver             &linear_solver,
                               TimerOutput              &timer,
                               const AirColumn          *air)
    : equations(equations)
    , contact(contact)
    , linear_solver(linear_solver)
    , timer(timer)
    , air(air)
    , tangent(equations, contact, timer)
    , mass(equations.mesh)
    , start(arbitrary_displacements(equations.mesh, 0))
  {
    // enough for modes of the same frequency
    constexpr unsigned int n_arbitrary = 6;

    const ShellMesh &mesh      = equations.mesh;
    const auto       add_field = [&](const LA::Vector &displacement) {
      LA::Vector ghosted  = mesh.ghosted_vector();
      ghosted             = displacement;
      LA::Vector   forces = inertia(mesh, ghosted);
      const double square = forces * displacement;
      mesh.condense(forces);
      if (translations.size() < 3)
        translations.push_back(forces);
      // per unit of energy, so that all fields count alike
      if (square > 0)
        forces /= std::sqrt(square);
      fields.push_back(forces);
    };
    for (const std::vector<double> &motion : rigid_motions(mesh))
      {
        LA::Vector displacement = mesh.owned_vector();
        std::copy(motion.begin(), motion.end(), displacement.begin());
        add_field(displacement);
      }
    for (unsigned int seed = 1; seed <= n_arbitrary; ++seed)
      add_field(arbitrary_displacements(mesh, seed));
  }


  double
  ModalAnalysis::largest_eigenvalue(const LA::SparseMatrix &K) const
  {
    const ShellMesh &mesh    = equations.mesh;
    double           largest = 0;
    for (const auto i : mesh.locally_owned)
      if (!mesh.constraints.is_constrained(i))
        largest =
          std::max(largest, K.diag_element(i) / mass.get().diag_element(i));
    return Utilities::MPI::max(largest, mesh.communicator);
  }


  bool
  ModalAnalysis::is_zero(const LA::SparseMatrix     &K,
                         const std::complex<double> &eigenvalue,
                         const LA::Vector           &vector) const
  {
    LA::Vector product(vector);
    mass.vmult(product, vector);
    return std::abs(eigenvalue) * (product * vector) <=
           roundoff(equations.mesh, K, vector);
  }


  VibrationMode
  ModalAnalysis::finish(const Eigenpair &pair,
                        const Loads     &loads,
                        const AirInMode &of_air) const
  {
    const ShellMesh &mesh       = equations.mesh;
    const bool       is_complex = pair.imaginary.size() > 0;
    VibrationMode    mode;
    mode.omega                     = pair.value;
    std::vector<LA::Vector> shapes = normalized_shapes(
      mesh,
      is_complex ? std::vector<LA::Vector>{pair.vector, pair.imaginary}
                 : std::vector<LA::Vector>{pair.vector});

    Tensor<1, 3> square;
    for (const LA::Vector &shape : shapes)
      {
        const LA::Vector owned = owned_part(shape);
        LA::Vector       product(owned);
        mass.vmult(product, owned);
        mode.mass += product * owned;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const double content  = translations[i] * owned;
            mode.participation[i] = content;
            square[i] += content * content;
          }
      }
    mode.part_of_air = 1 - of_air.part_of_shell;
    Tensor<1, 3> momentum;
    if (of_air.momentum.norm() > 0)
      {
        // of the shape, a multiple of the vector of the pair
        LA::Vector of_pair(pair.vector);
        mass.vmult(of_pair, pair.vector);
        momentum =
          std::sqrt(mode.mass / (of_pair * pair.vector)) * of_air.momentum;
      }
    mode.mass /= of_air.part_of_shell;
    for (unsigned int i = 0; i < 3; ++i)
      mode.participation[i] =
        (is_complex ? std::sqrt(square[i])
                    : mode.participation[i] + momentum[i]) /
        mode.mass;
    mode.shape = shapes[0];
    if (is_complex)
      mode.imaginary = shapes[1];
    mode.waves = wave_numbers(mesh, shapes);
    // in the direction of the wheel, which may roll backward
    if (mode.waves && loads.rolling && loads.rolling->angular_velocity < 0)
      mode.waves->travel *= -1;
    return mode;
  }


  namespace
  {
    // what an iterative solver may leave, relative to the right hand side
    constexpr double left_by_iterations = 1e-12;


    /** @param matrix is kept by reference. */
    template <typename Matrix>
    Multiply
    multiply_by(const Matrix &matrix)
    {
      return [&matrix](LA::Vector &product, const LA::Vector &x) {
        matrix.vmult(product, x);
      };
    }
  } // namespace


  /** @f$\mathbf K+i\omega\mathbf G-\omega^2\mathbf M@f$ and, with a shift
   * @f$\sigma@f$ of @f$\omega^2@f$, the matrix with
   * @f$i\omega=\sqrt{-\sigma}@f$. */
  struct ModalAnalysis::Problem
  {
    LA::SparseMatrix K;
    /** @f$\mathbf G@f$ of a shell that rolls or spins; else null. */
    std::unique_ptr<const VelocityMatrix> velocity;
    /** The stiffness of loads that follow from the displacements, beside K. */
    LowRankStiffness low_rank;
    /** The rigid motions whose frequency is zero; the others are orthogonal to
     * them. */
    std::vector<RigidMotion>       neutral;
    std::optional<const Deflation> deflation;
    /** Whether K is symmetric, and with the part of low rank. */
    bool symmetric_matrix = true, symmetric = true;
    /** See QuadraticEigenvalueProblem. */
    bool conservative = true;
    /** The air that vibrates with the shell, if any; its unknowns are then
     * part of all vectors. */
    AirMotion                   motion_of_air;
    std::optional<ShellWithAir> air;
    /** The product with the mass matrix. */
    Multiply multiply_mass;

    double           shift = 0;
    LA::SparseMatrix shifted;

    double
    rate_of_shift() const
    {
      return std::sqrt(-shift);
    }

    /** Let the air be part of the vectors.
     * @param structural a small eigenvalue of the shell.
     * @return whether the air is slow enough for that. */
    bool
    add_air(const ShellMesh  &mesh,
            const MassMatrix &mass,
            const double      structural)
    {
      // digits that round-off leaves to differences of pressures
      constexpr double too_fast = 1e8;

      air.emplace(mesh, mass, motion_of_air);
      multiply_mass = [this](LA::Vector &product, const LA::Vector &x) {
        air->multiply_mass(product, x);
      };
      if (const auto circulation = air->circulation(); !circulation.empty())
        deflation.emplace(circulation, multiply_mass);
      // the matrix of the air at rest is singular: a shift of the order of the
      // first wave
      const double first = motion_of_air.first_wave();
      shift              = -std::min(first, structural);
      return first < too_fast * structural;
    }

    /** Leave the shell in vectors with the air, which the result has apart. */
    std::vector<AirInMode>
    take_air_out(std::vector<Eigenpair> &pairs) const
    {
      std::vector<AirInMode> result;
      for (Eigenpair &pair : pairs)
        {
          result.push_back({air->part_of_shell(pair.vector),
                            air->momentum_of_air(pair.vector)});
          pair.vector = air->of_shell(pair.vector);
        }
      return result;
    }

    /** @f$\omega^2@f$ of an eigenvalue, which is @f$\omega@f$ if there are
     * gyroscopic terms. */
    std::complex<double>
    square(const Eigenpair &pair) const
    {
      return velocity ? pair.value * pair.value : pair.value;
    }
  };


  ModalAnalysis::Problem
  ModalAnalysis::assemble(const State &state, const Loads &loads)
  {
    Problem problem;
    tangent.assemble(state, loads, problem.K);
    tangent.add_contact_stiffness(state, loads, problem.K);
    problem.symmetric_matrix = tangent.is_symmetric(loads, problem.K);
    problem.low_rank         = LowRankStiffness(
      equations, state, FixedContactTangent::without_bodies(loads));
    problem.multiply_mass = multiply_by(mass);
    if (air)
      {
        // the waves contain the stiffness of the gas
        problem.low_rank      = LowRankStiffness();
        problem.motion_of_air = air->about(
          state, equations.with_dependent_loads(state, loads).pressure);
      }
    problem.symmetric =
      problem.symmetric_matrix && problem.low_rank.is_symmetric();
    problem.velocity     = make_velocity_matrix(contact, state, loads);
    problem.conservative = problem.symmetric && !contact.has_friction(loads);
    problem.neutral      = tangent.neutral_motions(state, loads, problem.K);
    if (!problem.neutral.empty())
      {
        std::vector<LA::Vector> motions;
        for (const RigidMotion &motion : problem.neutral)
          motions.push_back(motion.displacement);
        problem.deflation.emplace(motions, problem.multiply_mass);
      }
    return problem;
  }


  LinearSolverResult
  ModalAnalysis::factorize(Problem &problem) const
  {
    if (problem.shift == 0)
      return linear_solver.factorize_for_many(problem.K,
                                              problem.symmetric_matrix);
    problem.shifted.copy_from(problem.K);
    problem.shifted.add(-problem.shift, mass.get());
    if (problem.velocity)
      problem.shifted.add(problem.rate_of_shift(), problem.velocity->get());
    return linear_solver.factorize_for_many(
      problem.shifted, problem.symmetric_matrix && !problem.velocity);
  }


  Eigenpairs
  ModalAnalysis::nearest(const Problem      &problem,
                         const LinearSystem  system,
                         const unsigned int  n,
                         LinearSolverResult &linear) const
  {
    const bool transposed   = (system == LinearSystem::transposed);
    const auto solve_matrix = [&](LA::Vector &x, const LA::Vector &b) {
      linear = linear_solver.solve_system(system, x, b, left_by_iterations);
      return linear.success;
    };
    // the factors know neither the gas nor the motions to be left out, which
    // are corrected in each solution
    LowRankStiffness low_rank =
      (transposed ? problem.low_rank.transposed() : problem.low_rank);
    if (!low_rank.prepare(solve_matrix))
      {
        Eigenpairs result;
        result.message = "the tangent with the gas is singular";
        return result;
      }
    const auto solve_all = [&](LA::Vector &x, const LA::Vector &b) {
      if (!solve_matrix(x, b))
        return false;
      low_rank.correct(x);
      return true;
    };
    std::optional<ShellWithAir> air;
    if (problem.air)
      {
        air.emplace(*problem.air);
        if (!air->prepare(solve_all, problem.shift))
          {
            Eigenpairs result;
            result.message = "the tangent with the air is singular";
            return result;
          }
      }
    const auto solve_with_air = [&](LA::Vector &x, const LA::Vector &b) {
      return air ? air->solve(x, b, solve_all) : solve_all(x, b);
    };
    std::optional<Deflation> deflation;
    if (problem.deflation)
      {
        deflation.emplace(*problem.deflation);
        if (!deflation->prepare(solve_with_air))
          {
            Eigenpairs result;
            result.message = "the tangent is singular";
            return result;
          }
      }
    const auto solve = [&](LA::Vector &x, const LA::Vector &b) {
      return deflation ? deflation->solve(x, b, solve_with_air)
                       : solve_with_air(x, b);
    };

    if (problem.velocity)
      {
        QuadraticEigenvalueProblem quadratic;
        quadratic.solve             = solve;
        quadratic.multiply_mass     = multiply_by(mass);
        quadratic.multiply_velocity = [&](LA::Vector       &product,
                                          const LA::Vector &x) {
          if (transposed)
            problem.velocity->Tvmult(product, x);
          else
            problem.velocity->vmult(product, x);
        };
        quadratic.conservative = problem.conservative;
        quadratic.shift        = problem.rate_of_shift();
        return nearest_eigenpairs(quadratic, n, start);
      }
    EigenvalueProblem linear_problem;
    linear_problem.solve     = solve;
    linear_problem.multiply  = problem.multiply_mass;
    linear_problem.shift     = problem.shift;
    linear_problem.symmetric = problem.symmetric;
    return nearest_eigenpairs(
      linear_problem, n, air ? air->with_arbitrary_air(start) : start);
  }


  Eigenpairs
  ModalAnalysis::lowest(Problem &problem, const unsigned int n) const
  {
    // The shift of a singular matrix as a part of its largest eigenvalue, then
    // as a part of the largest one found. Round-off in an eigenvector next to
    // the shift spoils those much farther away.
    constexpr double first_shift = 1e-6, good_shift = 1e-2, max_spread = 1e5;
    constexpr unsigned int n_passes = 4;

    Eigenpairs eigenpairs;
    for (unsigned int pass = 0; pass < n_passes; ++pass)
      {
        LinearSolverResult linear = factorize(problem);
        eigenpairs                = Eigenpairs();
        if (linear.success)
          eigenpairs = nearest(problem, LinearSystem::original, n, linear);
        if (!eigenpairs.success)
          {
            if (!linear.success)
              eigenpairs.message = linear.message;
            // the first wave of the air was far above the modes
            if (problem.air && linear.success && pass + 1 < n_passes)
              {
                problem.shift *= 1e-4;
                continue;
              }
            if (linear.success || pass > 0 ||
                linear.cause != FailureCause::singular_tangent)
              break;
            problem.shift = -first_shift * largest_eigenvalue(problem.K);
            continue;
          }
        double farthest = 0, closest = std::numeric_limits<double>::infinity();
        double largest = 0;
        for (const Eigenpair &pair : eigenpairs.pairs)
          {
            const std::complex<double> square = problem.square(pair);
            const double distance = std::abs(square - problem.shift);
            farthest              = std::max(farthest, distance);
            closest               = std::min(closest, distance);
            largest               = std::max(largest, std::abs(square));
          }
        const bool is_good =
          (farthest <= max_spread * closest && -problem.shift <= largest);
        // the shift remains that of the factors
        if (is_good || pass + 1 == n_passes)
          break;
        problem.shift = -good_shift * largest;
      }
    return eigenpairs;
  }


  std::vector<Eigenpair>
  ModalAnalysis::find_left(const Problem                &problem,
                           const std::vector<Eigenpair> &right) const
  {
    LinearSolverResult     linear;
    std::vector<Eigenpair> found =
      nearest(problem, LinearSystem::transposed, right.size(), linear).pairs;
    if (problem.deflation)
      for (const LA::Vector &motion : problem.deflation->get_vectors())
        found.push_back({0, motion, {}});
    return left_eigenpairs(right, found, [&](const Eigenpair &x) {
      const Eigenpair of_mass = product(multiply_by(mass), x);
      if (!problem.velocity)
        return of_mass;
      // i G x - 2 omega M x
      const Eigenpair of_velocity = product(multiply_by(*problem.velocity), x);
      return combination({std::complex<double>(0, 1), -2. * x.value},
                         {of_velocity, of_mass});
    });
  }


  VibrationModes
  ModalAnalysis::compute(const State       &state,
                         const Loads       &loads,
                         const unsigned int n,
                         const bool         with_left)
  {
    TimerOutput::Scope scope(timer, "Modes");

    // some more, so that modes of the same frequency are complete
    const unsigned int n_computed = std::max(
      n, std::min<unsigned int>(n + 4, equations.mesh.n_unknowns() / 4));

    Problem problem = assemble(state, loads);
    if (air)
      {
        if (!problem.neutral.empty())
          {
            VibrationModes result;
            result.message = "with 'Gas/Sound speed' the shell must be held, "
                             "and nothing resists " +
                             problem.neutral[0].name;
            return result;
          }
        if (!problem.add_air(
              equations.mesh, mass, 1e-6 * largest_eigenvalue(problem.K)))
          {
            VibrationModes result;
            result.message = "'Gas/Sound speed' is too large to matter";
            return result;
          }
      }
    const unsigned int n_neutral = problem.neutral.size();
    const Eigenpairs   eigenpairs =
      lowest(problem, std::max(n_computed, n_neutral + 1) - n_neutral);
    VibrationModes result;
    result.success    = eigenpairs.success;
    result.message    = eigenpairs.message;
    result.total_mass = mass.total();
    result.with_air   = (air != nullptr);
    result.symmetric  = problem.symmetric && !problem.velocity;
    if (!result.success)
      return result;

    std::vector<Eigenpair> pairs = eigenpairs.pairs;
    // the circulation of the air moves nothing of the shell
    if (problem.deflation && !problem.air)
      for (const LA::Vector &motion : problem.deflation->get_vectors())
        pairs.push_back({0, motion, {}});
    for (const RigidMotion &motion : problem.neutral)
      result.neutral_motions.push_back(motion.name);
    for (Eigenpair &pair : pairs)
      {
        if (!problem.velocity)
          make_real(pair);
        if (!problem.air &&
            is_zero(problem.K, problem.square(pair), pair.vector))
          pair.value = 0;
      }
    std::vector<LA::Vector> all_fields = fields;
    if (problem.air)
      for (LA::Vector &field : all_fields)
        field = problem.air->with_air_at_rest(field);
    if (problem.velocity)
      normalize_phases(pairs, problem.multiply_mass, all_fields);
    else
      settle(pairs, problem.multiply_mass, all_fields);
    std::vector<AirInMode> of_air(pairs.size());
    if (problem.air)
      of_air = problem.take_air_out(pairs);
    std::vector<Eigenpair> left(pairs.size());
    if (with_left)
      left = (result.symmetric ? pairs : find_left(problem, pairs));
    for (unsigned int i = 0; i < pairs.size() && i < n; ++i)
      {
        // motions that nothing resists have no frequency that changes
        if (problem.deflation && pairs[i].value == 0.)
          left[i] = Eigenpair();
        if (!problem.velocity)
          pairs[i].value = omega_of(pairs[i].value);
        result.modes.push_back(finish(pairs[i], loads, of_air[i]));
        result.modes[i].left = left[i];
      }
    return result;
  }


  std::vector<std::complex<double>>
  omegas_for_shapes(ShellEquations           &equations,
                    const ContactInteraction &contact,
                    TimerOutput              &timer,
                    const State              &state,
                    const Loads              &loads,
                    const VibrationModes     &modes)
  {
    const ShellMesh    &mesh = equations.mesh;
    FixedContactTangent tangent(equations, contact, timer);
    LA::SparseMatrix    K;
    tangent.assemble(state, loads, K);
    tangent.add_contact_stiffness(state, loads, K);
    const LowRankStiffness low_rank(
      equations, state, FixedContactTangent::without_bodies(loads));
    const MassMatrix mass(mesh);
    const Multiply multiply_k = [&](LA::Vector &product, const LA::Vector &x) {
      K.vmult(product, x);
      low_rank.vmult_add(product, x);
    };

    // without the entries that constraints give, which the products do not
    // expect
    BothEigenpairs neighbors;
    for (const VibrationMode &mode : modes.modes)
      {
        Eigenpair right{mode.omega, owned_part(mode.shape), {}};
        mesh.constraints.set_zero(right.vector);
        if (mode.imaginary.size() > 0)
          {
            right.imaginary = owned_part(mode.imaginary);
            mesh.constraints.set_zero(right.imaginary);
          }
        neighbors.right.push_back(right);
        neighbors.left.push_back(mode.left);
      }
    if (const auto velocity = make_velocity_matrix(contact, state, loads))
      return rayleigh_roots(
        multiply_k, multiply_by(*velocity), multiply_by(mass), neighbors);
    std::vector<std::complex<double>> omegas =
      rayleigh_quotients(multiply_k, multiply_by(mass), neighbors);
    for (std::complex<double> &omega : omegas)
      omega = omega_of(omega);
    return omegas;
  }
} // namespace Biface
