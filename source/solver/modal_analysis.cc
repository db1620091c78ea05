// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <biface/model/rigid_motions.h>
#include <biface/model/velocity_matrix.h>
#include <biface/solver/gas_stiffness.h>
#include <biface/solver/modal_analysis.h>

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
                               TimerOutput              &timer)
    : equations(equations)
    , contact(contact)
    , linear_solver(linear_solver)
    , tangent(equations, contact, timer)
    , mass(equations.mesh)
    , start(arbitrary_displacements(equations.mesh, 0))
  {
    // enough for modes of the same frequency
    constexpr unsigned int n_arbitrary = 6;

    const ShellMesh &mesh      = equations.mesh;
    const auto       add_field = [&](const LA::Vector &displacement) {
      LA::Vector ghosted   = mesh.ghosted_vector();
      ghosted              = displacement;
      LA::Vector   inertia = mass.inertia(ghosted);
      const double square  = inertia * displacement;
      mesh.condense(inertia);
      if (translations.size() < 3)
        translations.push_back(inertia);
      if (square > 0)
        inertia /= std::sqrt(square);
      fields.push_back(inertia);
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
           tangent.roundoff(K, vector);
  }


  VibrationMode
  ModalAnalysis::finish(const Eigenpair &pair, const Loads &loads) const
  {
    const ShellMesh &mesh       = equations.mesh;
    const bool       is_complex = loads.rolling && pair.imaginary.size() > 0;
    VibrationMode    mode;
    mode.omega                     = pair.value;
    std::vector<LA::Vector> shapes = unit_shapes(
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
    for (unsigned int i = 0; i < 3; ++i)
      mode.participation[i] =
        (is_complex ? std::sqrt(square[i]) : mode.participation[i]) / mode.mass;
    mode.shape = shapes[0];
    if (is_complex)
      mode.imaginary = shapes[1];
    mode.waves = wave_numbers(mesh, shapes);
    if (mode.waves && loads.rolling && loads.rolling->angular_velocity < 0)
      mode.waves->travel *= -1;
    return mode;
  }


  VibrationModes
  ModalAnalysis::compute(const State       &state,
                         const Loads       &loads,
                         const Gas::Sealed *gas,
                         const unsigned int n)
  {
    const ShellMesh &mesh = equations.mesh;
    VibrationModes   result;
    result.total_mass = mass.total();

    LA::SparseMatrix K;
    tangent.assemble(state, loads, K);
    tangent.hold(state, loads, K);
    const Loads alone = HeldTangent::without_foundation(loads);

    EigenvalueProblem problem;
    problem.symmetric =
      (!(loads.rolling && loads.friction) && equations.is_symmetric(alone)) ||
      tangent.is_symmetric(K);
    std::unique_ptr<const VelocityMatrix> velocity;
    if (loads.rolling)
      velocity = std::make_unique<const VelocityMatrix>(contact, state, loads);
    LinearSolverResult linear;
    // what an iterative solver may leave, relative to the right hand side
    constexpr double exactness = 1e-12;
    const auto       solve     = [&](LA::Vector &x, const LA::Vector &b) {
      linear = linear_solver.solve(x, b, exactness);
      return linear.success;
    };

    bool                        symmetric_matrix = problem.symmetric;
    std::optional<GasStiffness> gas_stiffness;
    if (gas)
      {
        gas_stiffness.emplace(equations, state, loads, *gas);
        problem.symmetric = problem.symmetric && gas_stiffness->is_symmetric();
      }
    const auto prepare = [&](const LA::SparseMatrix &A) {
      linear = linear_solver.factorize_for_many(A, symmetric_matrix);
      return linear.success &&
             (!gas_stiffness || gas_stiffness->prepare(solve));
    };
    problem.solve = [&](LA::Vector &x, const LA::Vector &b) {
      if (!solve(x, b))
        return false;
      if (gas_stiffness)
        gas_stiffness->correct(x);
      return true;
    };
    problem.multiply = [&](LA::Vector &product, const LA::Vector &x) {
      mass.vmult(product, x);
    };

    QuadraticEigenvalueProblem quadratic;
    quadratic.solve             = problem.solve;
    quadratic.multiply_mass     = problem.multiply;
    quadratic.multiply_velocity = [&](LA::Vector       &product,
                                      const LA::Vector &x) {
      velocity->vmult(product, x);
    };
    quadratic.conservative =
      problem.symmetric && !(loads.foundation && loads.friction);

    // The shift of a singular matrix as a part of its greatest eigenvalue, then
    // as a part of the greatest one found. Round-off in an eigenvector next to
    // the shift spoils those much farther away.
    constexpr double first_shift = 1e-6, good_shift = 1e-2,
                     greatest_spread = 1e5;
    // some more, so that modes of the same frequency are complete
    const unsigned int n_computed =
      std::max(n, std::min<unsigned int>(n + 4, mesh.n_unknowns() / 4));
    Eigenpairs       eigenpairs;
    LA::SparseMatrix shifted;
    // of omega, which is the eigenvalue if there are gyroscopic terms
    const auto square = [&](const Eigenpair &pair) {
      return velocity ? pair.value * pair.value : pair.value;
    };
    for (unsigned int pass = 0; pass < 4; ++pass)
      {
        quadratic.shift = std::sqrt(-problem.shift);
        if (pass > 0)
          {
            shifted.copy_from(K);
            shifted.add(-problem.shift, mass.get());
            if (velocity)
              shifted.add(quadratic.shift, velocity->get());
          }
        eigenpairs = Eigenpairs();
        if (prepare(pass > 0 ? shifted : K))
          eigenpairs =
            (velocity ? nearest_eigenpairs(quadratic, n_computed, start)
                      : nearest_eigenpairs(problem, n_computed, start));

        if (!eigenpairs.success)
          {
            if (linear.success || pass > 0 ||
                linear.cause != FailureCause::singular_tangent)
              break;
            problem.shift    = -first_shift * largest_eigenvalue(K);
            symmetric_matrix = symmetric_matrix && !velocity;
            continue;
          }
        double largest = 0, nearest = std::numeric_limits<double>::infinity();
        double greatest = 0;
        for (const Eigenpair &pair : eigenpairs.pairs)
          {
            const double distance = std::abs(square(pair) - problem.shift);
            largest               = std::max(largest, distance);
            nearest               = std::min(nearest, distance);
            greatest              = std::max(greatest, std::abs(square(pair)));
          }
        if (largest <= greatest_spread * nearest && -problem.shift <= greatest)
          break;
        problem.shift    = -good_shift * greatest;
        symmetric_matrix = symmetric_matrix && !velocity;
      }
    if (!eigenpairs.success)
      {
        result.message = linear.success ? eigenpairs.message : linear.message;
        return result;
      }

    for (Eigenpair &pair : eigenpairs.pairs)
      {
        constexpr double real = 1e-8;
        if (std::abs(pair.value.imag()) <= real * std::abs(pair.value))
          pair.value.imag(0);
        if (is_zero(K, square(pair), pair.vector))
          pair.value = 0;
      }
    if (velocity)
      settle_phases(eigenpairs.pairs, problem.multiply, fields);
    else
      {
        settle(eigenpairs.pairs, problem.multiply, fields);
        for (Eigenpair &pair : eigenpairs.pairs)
          pair.value = omega_of(pair.value);
      }
    result.symmetric = problem.symmetric && !velocity;
    for (const Eigenpair &pair : eigenpairs.pairs)
      if (result.modes.size() < n)
        result.modes.push_back(finish(pair, loads));
    result.success = true;
    return result;
  }


  std::vector<double>
  squares_for_shapes(ShellEquations           &equations,
                     const ContactInteraction &contact,
                     TimerOutput              &timer,
                     const State              &state,
                     const Loads              &loads,
                     const Gas::Sealed        *gas,
                     const VibrationModes     &modes)
  {
    const ShellMesh &mesh = equations.mesh;
    HeldTangent      tangent(equations, contact, timer);
    LA::SparseMatrix K;
    tangent.assemble(state, loads, K);
    tangent.hold(state, loads, K);
    std::optional<const GasStiffness> gas_stiffness;
    if (gas)
      gas_stiffness.emplace(equations, state, loads, *gas);
    const MassMatrix mass(mesh);

    std::vector<LA::Vector>           shapes;
    std::vector<std::complex<double>> squares;
    for (const VibrationMode &mode : modes.modes)
      {
        shapes.push_back(owned_part(mode.shape));
        mesh.constraints.set_zero(shapes.back());
        squares.push_back(mode.square());
      }
    return rayleigh_quotients(
      [&](LA::Vector &product, const LA::Vector &x) {
        K.vmult(product, x);
        if (gas_stiffness)
          gas_stiffness->vmult_add(product, x);
      },
      [&](LA::Vector &product, const LA::Vector &x) { mass.vmult(product, x); },
      shapes,
      squares);
  }
} // namespace Biface
