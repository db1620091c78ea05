// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <biface/model/rigid_motions.h>
#include <biface/solver/modal_analysis.h>

namespace Biface
{
  using namespace dealii;

  double
  VibrationMode::frequency() const
  {
    return std::sqrt(square).real() / (2 * numbers::PI);
  }


  double
  VibrationMode::growth_rate() const
  {
    const std::complex<double> root = std::sqrt(square);
    return square.imag() == 0 ? root.imag() : -root.imag();
  }


  namespace
  {
    /** A number between -1 and 1 that looks random. */
    double
    scattered(const double seed)
    {
      const double value = std::sin(12.9898 * seed + 1) * 43758.5453;
      return 2 * (value - std::floor(value)) - 1;
    }


    /** Different displacements of the nodes for each @p seed, the same on any
     * number of ranks. */
    LA::Vector
    arbitrary_displacements(const ShellMesh &mesh, const unsigned int seed)
    {
      LA::Vector v = mesh.owned_vector();
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          for (unsigned int d = 0; d < 6; ++d)
            v(node.dofs[d]) =
              scattered(6. * node.number + d + std::sqrt(2.) * seed);
      v.compress(VectorOperation::insert);
      mesh.constraints.set_zero(v);
      return v;
    }


    /** The stiffness by which the foundation holds the nodes in contact. */
    void
    add_contact(const ContactInteraction &contact,
                const State              &state,
                const Loads              &loads,
                LA::SparseMatrix         &K)
    {
      const ShellMesh &mesh = contact.mesh;
      TangentMatrix    held(mesh, mesh.constraints);
      LA::Vector       nothing = mesh.owned_vector();
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          const Cell               &cell = mesh.cells[c];
          MixedElement::NodalMatrix matrix{};
          bool                      any = false;
          for (unsigned int v = 0; v < 4; ++v)
            {
              if (!state.active[cell.nodes[v]])
                continue;
              any               = true;
              const auto &frame = mesh.nodes[cell.nodes[v]].surface.frame;
              const Tensor<2, 3> stiffness =
                contact.traction(state, loads, cell.nodes[v]).stiffness;
              Tensor<2, 3> in_frame;
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  in_frame[i][j] = cell.geometry.weight / 8 *
                                   (frame[i] * (stiffness * frame[j]) +
                                    frame[j] * (stiffness * frame[i]));
              const double sign = cell.sign_of_outer_face(v);
              MixedElement::add_stiffness(in_frame, v, sign, v, sign, matrix);
            }
          if (any)
            held.add(c, matrix, MixedElement::NodalVector(), nothing);
        }
      held.compress();
      K.add(1., held.get());
    }


    /** Make the products with @p mass of real vectors those of the unit
     * matrix. */
    void
    orthonormalize(std::vector<LA::Vector> &vectors, const MassMatrix &mass)
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
                mass.vmult(product, vectors[i]);
                vectors[i].add(-(product * vectors[j]), vectors[j]);
              }
          mass.vmult(product, vectors[i]);
          vectors[i] /= std::sqrt(product * vectors[i]);
        }
    }
  } // namespace


  ModalAnalysis::ModalAnalysis(ShellEquations           &equations,
                               const ContactInteraction &contact,
                               LinearSolver             &linear_solver,
                               TimerOutput              &timer)
    : equations(equations)
    , contact(contact)
    , linear_solver(linear_solver)
    , timer(timer)
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


  void
  ModalAnalysis::assemble(const State      &state,
                          const Loads      &loads,
                          LA::SparseMatrix &K)
  {
    TimerOutput::Scope scope(timer, "Assembly");
    Loads              alone = loads;
    alone.foundation.reset();
    alone.friction.reset();
    equations.assemble(state, alone);
    K.copy_from(equations.tangent());
    if (loads.foundation)
      {
        State held = state;
        if (loads.friction)
          contact.set_glued(held, true);
        add_contact(contact, held, loads, K);
      }
  }


  bool
  ModalAnalysis::is_symmetric(const LA::SparseMatrix &K) const
  {
    const LA::Vector other = arbitrary_displacements(equations.mesh, 7);
    LA::Vector       product(start);
    K.vmult(product, start);
    double difference = other * product;
    K.vmult(product, other);
    difference -= start * product;
    return std::abs(difference) <=
           10 * (roundoff(K, start) + roundoff(K, other));
  }


  double
  ModalAnalysis::roundoff(const LA::SparseMatrix &K, const LA::Vector &x) const
  {
    const ShellMesh &mesh    = equations.mesh;
    LA::Vector       ghosted = mesh.ghosted_vector();
    ghosted                  = x;

    const Epetra_CrsMatrix &epetra = K.trilinos_matrix();
    double                  sum    = 0;
    for (int row = 0; row < epetra.NumMyRows(); ++row)
      sum +=
        absolute_product(K, row, ghosted) * std::abs(ghosted(epetra.GRID(row)));
    return std::numeric_limits<double>::epsilon() *
           Utilities::MPI::sum(sum, mesh.communicator);
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
  ModalAnalysis::is_zero(const LA::SparseMatrix &K, const Eigenpair &pair) const
  {
    LA::Vector product(pair.vector);
    mass.vmult(product, pair.vector);
    return std::abs(pair.value) * (product * pair.vector) <=
           roundoff(K, pair.vector);
  }


  void
  ModalAnalysis::settle(std::vector<Eigenpair> &pairs) const
  {
    // relative distance of frequencies that are the same, and the part of a
    // field in a group of modes that is not round-off
    constexpr double same = 1e-7, significant = 1e-5;

    std::stable_sort(
      pairs.begin(), pairs.end(), [](const auto &a, const auto &b) {
        return a.value.real() < b.value.real();
      });

    LA::Vector product(start);
    for (unsigned int begin = 0, end = 0; begin < pairs.size(); begin = end)
      {
        end                   = begin + 1;
        const bool is_complex = (pairs[begin].value.imag() != 0);
        while (end < pairs.size() && !is_complex &&
               pairs[end].value.imag() == 0 &&
               std::abs(pairs[end].value - pairs[end - 1].value) <=
                 same * std::abs(pairs[end].value))
          ++end;

        if (is_complex)
          {
            // the phase with the largest real part
            LA::Vector &a = pairs[begin].vector;
            LA::Vector &b = pairs[begin].imaginary;
            mass.vmult(product, a);
            const double aa = product * a, ab = product * b;
            mass.vmult(product, b);
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
          orthonormalize(vectors, mass);

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


  VibrationMode
  ModalAnalysis::finish(const Eigenpair &pair) const
  {
    const ShellMesh &mesh = equations.mesh;
    VibrationMode    mode;
    mode.square = pair.value;

    LA::Vector owned(pair.vector);
    mesh.constraints.distribute(owned);
    mode.shape     = mesh.ghosted_vector();
    mode.shape     = owned;
    double largest = 0;
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int face = 0; face < 2; ++face)
          largest =
            std::max(largest, mesh.displacement(mode.shape, node, face).norm());
    owned /= Utilities::MPI::max(largest, mesh.communicator);
    mode.shape = owned;

    LA::Vector product(owned);
    mass.vmult(product, owned);
    mode.mass = product * owned;
    for (unsigned int i = 0; i < 3; ++i)
      mode.participation[i] = translations[i] * owned / mode.mass;
    mode.waves = wave_numbers(mesh, mode.shape);
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
    assemble(state, loads, K);
    Loads alone = loads;
    alone.foundation.reset();
    alone.friction.reset();

    EigenvalueProblem problem;
    problem.symmetric = equations.is_symmetric(alone) || is_symmetric(K);
    LinearSolverResult linear;
    // what an iterative solver may leave, relative to the right hand side
    constexpr double exactness = 1e-12;
    const auto       solve     = [&](LA::Vector &x, const LA::Vector &b) {
      linear = linear_solver.solve(x, b, exactness);
      return linear.success;
    };

    // a term of rank one, see Gas; it has the form of Newton's iteration
    const bool symmetric_matrix = problem.symmetric;
    LA::Vector forces, gradient, per_pressure;
    double     denominator = 1;
    if (gas)
      {
        LoadRates pressure_alone;
        pressure_alone.pressure = 1;
        forces   = equations.load_direction(state, alone, pressure_alone);
        gradient = gas->pressure_gradient(state);
        mesh.condense(gradient);
        per_pressure = mesh.owned_vector();

        constexpr double parallel = 1e-8;
        LA::Vector       difference(forces);
        difference /= forces.l2_norm();
        difference.add((gradient * forces < 0 ? 1 : -1) / gradient.l2_norm(),
                       gradient);
        if (difference.l2_norm() > parallel)
          problem.symmetric = false;
      }
    const auto prepare = [&](const LA::SparseMatrix &A) {
      linear = linear_solver.factorize_for_many(A, symmetric_matrix);
      if (!linear.success)
        return false;
      if (gas)
        {
          if (!solve(per_pressure, forces))
            return false;
          denominator = 1 - gradient * per_pressure;
        }
      return denominator != 0;
    };
    problem.solve = [&](LA::Vector &x, const LA::Vector &b) {
      if (!solve(x, b))
        return false;
      if (gas)
        x.add(gradient * x / denominator, per_pressure);
      return true;
    };
    problem.multiply = [&](LA::Vector &product, const LA::Vector &x) {
      mass.vmult(product, x);
    };

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
    for (unsigned int pass = 0; pass < 4; ++pass)
      {
        if (pass > 0)
          {
            shifted.copy_from(K);
            shifted.add(-problem.shift, mass.get());
          }
        eigenpairs = Eigenpairs();
        if (prepare(pass > 0 ? shifted : K))
          eigenpairs = nearest_eigenpairs(problem, n_computed, start);

        if (!eigenpairs.success)
          {
            if (linear.success || pass > 0 ||
                linear.cause != FailureCause::singular_tangent)
              break;
            problem.shift = -first_shift * largest_eigenvalue(K);
            continue;
          }
        double largest = 0, nearest = std::numeric_limits<double>::infinity();
        double greatest = 0;
        for (const Eigenpair &pair : eigenpairs.pairs)
          {
            const double distance = std::abs(pair.value - problem.shift);
            largest               = std::max(largest, distance);
            nearest               = std::min(nearest, distance);
            greatest              = std::max(greatest, std::abs(pair.value));
          }
        if (largest <= greatest_spread * nearest && -problem.shift <= greatest)
          break;
        problem.shift = -good_shift * greatest;
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
        if (is_zero(K, pair))
          pair.value = 0;
      }
    settle(eigenpairs.pairs);
    for (const Eigenpair &pair : eigenpairs.pairs)
      if (result.modes.size() < n)
        result.modes.push_back(finish(pair));
    result.success = true;
    return result;
  }
} // namespace Biface
