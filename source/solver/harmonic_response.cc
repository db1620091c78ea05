// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/lac/affine_constraints.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

#include <biface/base/gather.h>
#include <biface/laminate/loss_of_material.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/mass_matrix.h>
#include <biface/model/equations/velocity_matrix.h>
#include <biface/model/forces/dependent_loads.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/point_displacement.h>
#include <biface/solver/fixed_contact_tangent.h>
#include <biface/solver/harmonic_response.h>
#include <biface/solver/linear/complex_solver.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    using Number = std::complex<double>;

    /** Complex amplitudes of all unknowns of the nodes, owned entries. */
    struct Amplitudes
    {
      LA::Vector real, imaginary;

      void
      add(const Number &factor, const LA::Vector &x)
      {
        real.add(factor.real(), x);
        imaginary.add(factor.imag(), x);
      }

      /** Add a multiple of other amplitudes. */
      void
      add(const Number &factor, const Amplitudes &x)
      {
        add(factor, x.real);
        add(factor * Number(0, 1), x.imaginary);
      }

      Number
      operator*(const LA::Vector &x) const
      {
        return {real * x, imaginary * x};
      }
    };


    Amplitudes
    zero(const ShellMesh &mesh)
    {
      return {mesh.owned_vector(), mesh.owned_vector()};
    }


    /** Add a multiple of the product of a real matrix. */
    void
    vmult_add(Amplitudes             &product,
              const Number           &factor,
              const LA::SparseMatrix &matrix,
              const Amplitudes       &x)
    {
      LA::Vector part(x.real);
      matrix.vmult(part, x.real);
      product.add(factor, part);
      matrix.vmult(part, x.imaginary);
      product.add(factor * Number(0, 1), part);
    }


    /** A real matrix in the unknowns of all nodes, supported ones included. */
    struct Part
    {
      std::unique_ptr<const TangentMatrix>  matrix;
      std::unique_ptr<const VelocityMatrix> velocity;

      const LA::SparseMatrix &
      get() const
      {
        return matrix ? matrix->get() : velocity->get();
      }
    };


    /** The derivative of the forces of a body by displacements of the shell
     * relative to it, and by such velocities: each a sum of parts with a
     * sign. */
    struct ContactOfBody
    {
      unsigned int                                             number;
      std::string                                              name;
      std::vector<std::pair<double, const LA::SparseMatrix *>> stiffness,
        velocity;

      /** Add the forces on the shell that moves by @p x relative to the
       * body. */
      void
      add_forces(Amplitudes       &forces,
                 const Amplitudes &x,
                 const double      omega,
                 const double      loss_factor) const
      {
        for (const auto &[sign, matrix] : stiffness)
          vmult_add(forces, -sign * Number(1, loss_factor), *matrix, x);
        for (const auto &[sign, matrix] : velocity)
          vmult_add(forces, -sign * Number(0, omega), *matrix, x);
      }
    };


    /** The load that follows from the displacements of the whole shell: the
     * matrix has the part @f$-\mathbf f\,\mathbf g^T@f$. */
    struct RankOne
    {
      LA::Vector forces, gradient;
    };


    /** The losses of the materials of all ranks. */
    std::map<std::string, LossOfMaterial>
    losses_on_all(const ShellMesh &mesh, const double temperature)
    {
      std::map<std::string, LossOfMaterial> result;
      for (const Strip &strip : mesh.strips)
        result.merge(losses(strip.laminate, temperature));
      for (auto &of_rank : gather_on_all(mesh.communicator, result))
        result.merge(of_rank);
      return result;
    }


    /** The stiffness that the plies of a material give, by which all moduli are
     * linear in the material's. */
    std::unique_ptr<const TangentMatrix>
    stiffness_of_material(const InternalForces            &internal,
                          const AffineConstraints<double> &none,
                          const ShellMesh                 &mesh,
                          const State                     &state,
                          const std::string               &material)
    {
      // the law of a wall is linear in the moduli of its plies but for
      // thickness stress and transverse shear, which are smooth in them
      constexpr double change = 1e-3;

      auto       result  = std::make_unique<TangentMatrix>(mesh, none);
      LA::Vector nothing = mesh.owned_vector();
      std::map<unsigned int, std::pair<Laminate, Laminate>> scaled;
      for (const unsigned int c : mesh.layers)
        {
          const unsigned int strip    = mesh.cells[c].strip;
          const Laminate    &laminate = mesh.strips[strip].laminate;
          const auto        &plies    = laminate.get_plies();
          if (std::none_of(plies.begin(), plies.end(), [&](const Ply &ply) {
                return ply.material.name == material;
              }))
            continue;
          const auto &[less, more] =
            scaled
              .try_emplace(strip,
                           with_scaled_material(laminate, material, 1 - change),
                           with_scaled_material(laminate, material, 1 + change))
              .first->second;
          MixedElement::NodalMatrix K{};
          internal.add_law(state, c, more, 0.5 / change, K);
          internal.add_law(state, c, less, -0.5 / change, K);
          result->add(c, K, MixedElement::NodalVector(), nothing);
        }
      result->compress();
      return result;
    }


    std::unique_ptr<const TangentMatrix>
    damping_of_stiffness(const InternalForces            &internal,
                         const AffineConstraints<double> &none,
                         const ShellMesh                 &mesh,
                         const State                     &state)
    {
      auto       result  = std::make_unique<TangentMatrix>(mesh, none);
      LA::Vector nothing = mesh.owned_vector();
      for (const unsigned int c : mesh.layers)
        {
          MixedElement::NodalMatrix C{};
          internal.add_damping(state, c, C);
          result->add(c, C, MixedElement::NodalVector(), nothing);
        }
      result->compress();
      return result;
    }


    /** Sums complex multiples of real matrices into the entries of the system
     * of the free unknowns, whose pattern is found once. */
    class Condensed
    {
    public:
      /** @param widest a matrix whose pattern contains those of all. */
      Condensed(const ShellMesh        &mesh,
                const LA::SparseMatrix &widest,
                const bool              symmetric)
        : mesh(mesh), symmetric(symmetric)
      {
        const Epetra_CrsMatrix &epetra = widest.trilinos_matrix();
        for (int row = 0; row < epetra.NumMyRows(); ++row)
          {
            int     n;
            double *values;
            int    *columns;
            epetra.ExtractMyRowView(row, n, values, columns);
            rows.emplace_back();
            for (int k = 0; k < n; ++k)
              {
                rows.back()[epetra.GCID(columns[k])] = targets.size();
                targets.emplace_back();
                add_targets(epetra.GRID(row), epetra.GCID(columns[k]));
              }
          }
        // what is constrained follows from the others
        n_free_entries = places.size();
        for (const auto i : mesh.locally_owned)
          if (mesh.constraints.is_constrained(i))
            places.push_back(place(i, i));
      }

      const std::vector<ComplexSolver::Place> &
      get_places() const
      {
        return places;
      }

      /** The positions of the entries of a matrix among those of the widest. */
      std::vector<unsigned int>
      positions(const LA::SparseMatrix &matrix) const
      {
        const Epetra_CrsMatrix   &epetra = matrix.trilinos_matrix();
        std::vector<unsigned int> result;
        for (int row = 0; row < epetra.NumMyRows(); ++row)
          {
            int     n;
            double *values;
            int    *columns;
            epetra.ExtractMyRowView(row, n, values, columns);
            for (int k = 0; k < n; ++k)
              result.push_back(rows[row].at(epetra.GCID(columns[k])));
          }
        return result;
      }

      /** Add a multiple of a matrix to the entries. */
      void
      add(const Number                    &factor,
          const LA::SparseMatrix          &matrix,
          const std::vector<unsigned int> &positions,
          std::vector<Number>             &entries) const
      {
        const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
        unsigned int            next   = 0;
        for (int row = 0; row < epetra.NumMyRows(); ++row)
          {
            int     n;
            double *values;
            int    *columns;
            epetra.ExtractMyRowView(row, n, values, columns);
            for (int k = 0; k < n; ++k, ++next)
              for (const auto &[target, weight] : targets[positions[next]])
                entries[target] += factor * (weight * values[k]);
          }
      }

      /** Set the diagonal of constrained unknowns. */
      void
      set_constrained(std::vector<Number> &entries) const
      {
        double largest = 0;
        for (unsigned int k = 0; k < n_free_entries; ++k)
          largest = std::max(largest, std::abs(entries[k]));
        std::fill(entries.begin() + n_free_entries, entries.end(), largest);
      }

    private:
      static ComplexSolver::Place
      place(const types::global_dof_index row,
            const types::global_dof_index column)
      {
        return {static_cast<unsigned int>(row),
                static_cast<unsigned int>(column)};
      }

      /** The free unknowns that a degree of freedom depends on. */
      std::vector<std::pair<types::global_dof_index, double>>
      free_unknowns(const types::global_dof_index dof) const
      {
        if (!mesh.constraints.is_constrained(dof))
          return {{dof, 1.}};
        return *mesh.constraints.get_constraint_entries(dof);
      }

      void
      add_targets(const types::global_dof_index row,
                  const types::global_dof_index column)
      {
        for (const auto &[i, of_row] : free_unknowns(row))
          for (const auto &[j, of_column] : free_unknowns(column))
            if (!symmetric || i >= j)
              {
                targets.back().emplace_back(places.size(), of_row * of_column);
                places.push_back(place(i, j));
              }
      }

      const ShellMesh &mesh;
      const bool       symmetric;
      /** For each entry of the widest matrix, the entries of the system to
       * which it is added, with factors. */
      std::vector<std::vector<std::pair<unsigned int, double>>> targets;
      std::vector<ComplexSolver::Place>                         places;
      unsigned int n_free_entries = 0;
      /** By the row of this rank, the position of the entry in a column. */
      std::vector<std::unordered_map<int, unsigned int>> rows;
    };
  } // namespace


  namespace
  {
    struct Problem
    {
      const ShellMesh                 &mesh;
      const HarmonicResponse::Request &request;
      /** No constraints, of which the parts are. */
      AffineConstraints<double> none;

      /** The stiffness without bodies. */
      Part K, M;
      /** The gyroscopic matrix without bodies; empty if the shell stands. */
      Part G, K_0;
      /** The losses of materials and their stiffness. */
      std::vector<std::pair<LossOfMaterial, Part>> materials;
      /** The matrices from which those of bodies follow. */
      std::vector<Part>          of_bodies;
      std::vector<ContactOfBody> bodies;
      std::vector<RankOne>       low_rank;
      bool                       symmetric = true;
      /** The translations along x, y and z of all nodes. */
      std::vector<LA::Vector> translations;

      Problem(const ShellMesh &mesh, const HarmonicResponse::Request &request)
        : mesh(mesh), request(request), none(mesh.locally_relevant)
      {
        none.close();
        const auto motions = rigid_motions(mesh);
        for (unsigned int i = 0; i < 3; ++i)
          {
            translations.push_back(mesh.owned_vector());
            std::copy(motions[i].begin(),
                      motions[i].end(),
                      translations.back().begin());
          }
      }

      /** Call a function with each matrix of the shell without bodies and its
       * factor. */
      template <typename Function>
      void
      for_each_part(const double omega, const Function &function) const
      {
        function(Number(1, request.loss_factor), K.get());
        function(Number(-omega * omega, omega * request.damping.of_mass),
                 M.get());
        if (G.velocity)
          function(Number(0, omega), G.get());
        if (K_0.matrix)
          function(Number(0, omega * request.damping.of_stiffness), K_0.get());
        for (const auto &[loss, part] : materials)
          function(loss.factor(omega) - 1., part.get());
      }

      /** Call a function with each matrix of a body and its factor. */
      template <typename Function>
      void
      for_each_part_of_bodies(const double    omega,
                              const Function &function) const
      {
        for (const ContactOfBody &body : bodies)
          {
            for (const auto &[sign, matrix] : body.stiffness)
              function(sign * Number(1, request.loss_factor), *matrix);
            for (const auto &[sign, matrix] : body.velocity)
              function(sign * Number(0, omega), *matrix);
          }
      }

      /** The product with the matrix of all unknowns. */
      Amplitudes
      product(const double omega, const Amplitudes &u) const
      {
        Amplitudes result = zero(mesh);
        const auto add    = [&](const Number           &factor,
                             const LA::SparseMatrix &matrix) {
          vmult_add(result, factor, matrix, u);
        };
        for_each_part(omega, add);
        for_each_part_of_bodies(omega, add);
        for (const RankOne &part : low_rank)
          result.add(-(u * part.gradient), part.forces);
        return result;
      }

      /** An excitation at a frequency. */
      struct Excited
      {
        /** The forces on all unknowns. */
        Amplitudes forces;
        /** What supports prescribe, in the unknowns that they hold. */
        LA::Vector prescribed;
        /** The motion of the whole shell on which the solution counts. */
        const LA::Vector *rigid = nullptr;
      };

      Excited
      excite(const Excitation &excitation,
             const LA::Vector *forces,
             const double      omega) const
      {
        Excited result{zero(mesh), mesh.owned_vector()};
        if (excitation.loads)
          {
            result.forces.add(1, *forces);
            for (const PrescribedDisplacement &p : mesh.prescribed)
              if (mesh.locally_owned.is_element(p.dof))
                for (unsigned int i = 0; i < p.values.size(); ++i)
                  result.prescribed(p.dof) +=
                    factor_at(excitation.loads->factors, i) * p.values[i];
            result.prescribed.compress(VectorOperation::add);
            return result;
          }
        Amplitudes moves = zero(mesh);
        moves.add(1, translations[excitation.direction]);
        if (excitation.body)
          {
            // relative to the body, the shell moves the other way
            for (const ContactOfBody &body : bodies)
              if (body.number == *excitation.body)
                body.add_forces(
                  result.forces, moves, omega, request.loss_factor);
            result.forces.real *= -1;
            result.forces.imaginary *= -1;
            return result;
          }
        result.rigid = &translations[excitation.direction];
        for (const ContactOfBody &body : bodies)
          body.add_forces(result.forces, moves, omega, request.loss_factor);
        vmult_add(result.forces,
                  Number(omega * omega, -omega * request.damping.of_mass),
                  M.get(),
                  moves);
        if (G.velocity)
          vmult_add(result.forces, Number(0, -omega), G.get(), moves);
        return result;
      }
    };


    /** Leave what is work-conjugate to the free unknowns. */
    void
    condense(const ShellMesh &mesh, Amplitudes &forces)
    {
      for (LA::Vector *part : {&forces.real, &forces.imaginary})
        {
          mesh.condense(*part);
          part->compress(VectorOperation::add);
          mesh.constraints.set_zero(*part);
        }
    }


    ComplexSolver::Vector
    own_entries(const Amplitudes &x)
    {
      ComplexSolver::Vector result;
      for (unsigned int k = 0; k < x.real.locally_owned_size(); ++k)
        result.emplace_back(x.real.begin()[k], x.imaginary.begin()[k]);
      return result;
    }


    Amplitudes
    amplitudes(const ShellMesh &mesh, const ComplexSolver::Vector &x)
    {
      Amplitudes result = zero(mesh);
      for (unsigned int k = 0; k < x.size(); ++k)
        {
          result.real.begin()[k]      = x[k].real();
          result.imaginary.begin()[k] = x[k].imag();
        }
      for (LA::Vector *part : {&result.real, &result.imaginary})
        mesh.constraints.distribute(*part);
      return result;
    }


    double
    norm(const Amplitudes &x)
    {
      return std::hypot(x.real.l2_norm(), x.imaginary.l2_norm());
    }
  } // namespace


  namespace
  {
    /** The names of FrequencyResponse::outputs in the order of measure(). */
    std::vector<FrequencyResponse::Output>
    outputs_of(const ShellMesh &mesh, const std::vector<ContactOfBody> &bodies)
    {
      std::vector<FrequencyResponse::Output> result;
      for (const NamedPoint &point : mesh.points)
        for (const char *face : {"inner", "outer"})
          result.push_back({point.name, face});
      for (const std::string &support : mesh.supported.bodies)
        result.push_back({support, "force"});
      for (const ContactOfBody &body : bodies)
        result.push_back({body.name, "force"});
      return result;
    }


    /** Solutions of the system at one frequency. */
    class SystemAt
    {
    public:
      /** @param solve replaces right-hand sides by solutions with the matrix
       * without its part of low rank. */
      SystemAt(
        const ShellMesh            &mesh,
        const std::vector<RankOne> &low_rank,
        const std::function<bool(std::vector<ComplexSolver::Vector> &)> &solve)
        : mesh(mesh), low_rank(low_rank), solve(solve)
      {}

      /** Replace right-hand sides by solutions.
       * @return whether this succeeded. */
      bool
      operator()(std::vector<Amplitudes> &x)
      {
        const unsigned int                 n = x.size(), m = low_rank.size();
        std::vector<ComplexSolver::Vector> b;
        for (const Amplitudes &forces : x)
          b.push_back(own_entries(forces));
        for (const RankOne &part : low_rank)
          {
            Amplitudes forces = zero(mesh);
            forces.add(1, part.forces);
            condense(mesh, forces);
            b.push_back(own_entries(forces));
          }
        if (!solve(b))
          return false;
        std::vector<Amplitudes> per_load;
        for (unsigned int k = 0; k < m; ++k)
          per_load.push_back(amplitudes(mesh, b[n + k]));
        // the Woodbury formula
        FullMatrix<Number> system(m, m);
        for (unsigned int k = 0; k < m; ++k)
          for (unsigned int l = 0; l < m; ++l)
            system(k, l) = Number(k == l) - per_load[l] * low_rank[k].gradient;
        if (m > 0)
          system.gauss_jordan();
        for (unsigned int i = 0; i < n; ++i)
          {
            x[i] = amplitudes(mesh, b[i]);
            std::vector<Number> work;
            for (const RankOne &part : low_rank)
              work.push_back(x[i] * part.gradient);
            for (unsigned int k = 0; k < m; ++k)
              for (unsigned int l = 0; l < m; ++l)
                x[i].add(system(k, l) * work[l], per_load[k]);
          }
        return true;
      }

    private:
      const ShellMesh                                                &mesh;
      const std::vector<RankOne>                                     &low_rank;
      const std::function<bool(std::vector<ComplexSolver::Vector> &)> solve;
    };
  } // namespace


  FrequencyResponse
  HarmonicResponse::compute(const State                 &given,
                            const Loads                 &loads,
                            const Request               &request,
                            const std::function<bool()> &stop)
  {
    TimerOutput::Scope scope(timer, "Response");
    const ShellMesh   &mesh     = equations.mesh;
    const auto        &internal = equations.internal_forces();

    // where stresses relax, the elastic law, which is the instantaneous one
    State state = given;
    state.terms.erase(internal.name());
    const State shape = internal.in_shape_of_tangent(state);

    Problem problem(mesh, request);
    {
      FixedContactTangent tangent(equations, contact, timer);
      LA::SparseMatrix    K;
      tangent.assemble(state, loads, K);
      problem.symmetric = tangent.is_symmetric(loads, K) && !loads.rolling;
    }
    const bool  rolls     = FixedContactTangent::rolls_with_friction(loads);
    const Loads alone     = FixedContactTangent::without_bodies(loads);
    const auto  assembled = [&](const Loads &which) {
      const auto [of_stresses, now] =
        FixedContactTangent::of_tangent(state, which);
      return equations.tangent_with(problem.none, of_stresses, now);
    };
    problem.K.matrix = assembled(alone);
    {
      auto       mass    = std::make_unique<TangentMatrix>(mesh, problem.none);
      LA::Vector nothing = mesh.owned_vector();
      for (const unsigned int c : mesh.layers)
        mass->add(c,
                  cell_mass(mesh, mesh.cells[c]),
                  MixedElement::NodalVector(),
                  nothing);
      mass->compress();
      problem.M.matrix = std::move(mass);
    }
    if (loads.rolling)
      problem.G.velocity = std::make_unique<const VelocityMatrix>(
        contact, state, alone, problem.none);
    if (request.damping.of_stiffness > 0)
      problem.K_0.matrix =
        damping_of_stiffness(internal, problem.none, mesh, shape);
    for (const auto &[name, loss] : losses_on_all(mesh, request.temperature))
      problem.materials.push_back(
        {loss,
         Part{stiffness_of_material(internal, problem.none, mesh, shape, name),
              nullptr}});

    // the matrices stay where they are
    problem.of_bodies.reserve(contact.pairs.size() + 2);
    for (const auto &pair : contact.pairs)
      {
        const PlacedBody *const body = pair->body(loads);
        if (!body)
          continue;
        ContactOfBody of_body{pair->number, body->name, {}, {}};
        if (rolls)
          {
            problem.of_bodies.push_back({assembled(loads), nullptr});
            of_body.stiffness = {{1., &problem.of_bodies.back().get()},
                                 {-1., &problem.K.get()}};
            problem.of_bodies.push_back(
              {nullptr,
               std::make_unique<const VelocityMatrix>(
                 contact, state, loads, problem.none)});
            of_body.velocity = {{1., &problem.of_bodies.back().get()},
                                {-1., &problem.G.get()}};
          }
        else
          {
            auto stiffness =
              std::make_unique<TangentMatrix>(mesh, problem.none);
            FixedContactTangent::add_stiffness_of(
              *pair, state, loads, *stiffness);
            stiffness->compress();
            problem.of_bodies.push_back({std::move(stiffness), nullptr});
            of_body.stiffness = {{1., &problem.of_bodies.back().get()}};
          }
        problem.bodies.push_back(of_body);
      }

    std::vector<DependentLoads> dependent;
    for (const ForceTerm *term : equations.get_terms())
      term->add_dependent_loads(shape, alone, dependent);
    for (const DependentLoads &load : dependent)
      {
        LA::Vector gradient = mesh.owned_vector();
        gradient            = load.gradient;
        problem.low_rank.push_back(
          {equations.nodal_load_rates(shape, alone, load.rates), gradient});
      }

    std::vector<LA::Vector> forces;
    for (const Excitation &excitation : request.excitations)
      forces.push_back(excitation.loads ? equations.nodal_load_rates(
                                            shape, alone, *excitation.loads)
                                        : mesh.owned_vector());

    // a wheel that rolls has the entries of its contact
    const LA::SparseMatrix &widest =
      (rolls ? problem.of_bodies[0].get() : problem.K.get());
    const Condensed condensed(mesh, widest, problem.symmetric);
    std::map<const LA::SparseMatrix *, std::vector<unsigned int>> positions;
    const auto find_positions = [&](const Number &,
                                    const LA::SparseMatrix &matrix) {
      if (positions.count(&matrix) == 0)
        positions[&matrix] = condensed.positions(matrix);
    };
    problem.for_each_part(1, find_positions);
    problem.for_each_part_of_bodies(1, find_positions);
    ComplexSolver       solver(mesh.communicator,
                         mesh.locally_owned.n_elements(),
                         condensed.get_places(),
                         problem.symmetric);
    std::vector<Number> entries(condensed.get_places().size());

    FrequencyResponse result;
    result.frequencies = request.frequencies;
    result.outputs     = outputs_of(mesh, problem.bodies);
    for (const Excitation &excitation : request.excitations)
      result.excitations.push_back(excitation.name);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const FrequencyResponse::Value unknown{
      {{nan, nan}, {nan, nan}, {nan, nan}}};

    for (const double frequency : request.frequencies)
      {
        result.values.emplace_back(request.excitations.size(),
                                   std::vector<FrequencyResponse::Value>(
                                     result.outputs.size(), unknown));
        if (stop && stop())
          {
            result.message = "the run was stopped";
            ++result.n_failed;
            continue;
          }
        const double omega = 2 * numbers::PI * frequency;
        std::fill(entries.begin(), entries.end(), 0.);
        const auto add = [&](const Number           &factor,
                             const LA::SparseMatrix &matrix) {
          condensed.add(factor, matrix, positions.at(&matrix), entries);
        };
        problem.for_each_part(omega, add);
        problem.for_each_part_of_bodies(omega, add);
        condensed.set_constrained(entries);
        if (const std::string why = solver.factorize(entries); !why.empty())
          {
            result.message = why;
            ++result.n_failed;
            continue;
          }
        const auto solve_matrix = [&](std::vector<ComplexSolver::Vector> &x) {
          return solver.solve(x);
        };
        SystemAt solve(mesh, problem.low_rank, solve_matrix);

        std::vector<Problem::Excited> excited;
        std::vector<Amplitudes>       b, x;
        for (unsigned int i = 0; i < request.excitations.size(); ++i)
          {
            excited.push_back(
              problem.excite(request.excitations[i], &forces[i], omega));
            Amplitudes rhs = excited[i].forces;
            if (excited[i].prescribed.linfty_norm() > 0)
              {
                Amplitudes prescribed = zero(mesh);
                prescribed.add(1, excited[i].prescribed);
                rhs.add(-1, problem.product(omega, prescribed));
              }
            condense(mesh, rhs);
            b.push_back(rhs);
          }
        x            = b;
        bool success = solve(x);
        // once more for what round-off has left
        for (unsigned int round = 0; success && round < 2; ++round)
          {
            std::vector<Amplitudes> rest    = b;
            double                  largest = 0;
            for (unsigned int i = 0; i < x.size(); ++i)
              {
                Amplitudes product = problem.product(omega, x[i]);
                condense(mesh, product);
                rest[i].add(-1, product);
                if (const double scale = norm(b[i]); scale > 0)
                  largest = std::max(largest, norm(rest[i]) / scale);
              }
            constexpr double exact = 1e-10, sufficient = 1e-6;
            if (round == 1 && !(largest < sufficient))
              {
                success        = false;
                result.message = "the solution is not exact";
              }
            if (largest < exact || round == 1)
              break;
            success = solve(rest);
            for (unsigned int i = 0; i < x.size(); ++i)
              x[i].add(1, rest[i]);
          }
        if (!success)
          {
            ++result.n_failed;
            if (result.message.empty())
              result.message = "the matrix is singular";
            continue;
          }

        for (unsigned int i = 0; i < x.size(); ++i)
          {
            Amplitudes u = x[i];
            u.real += excited[i].prescribed;
            // what is missing on all unknowns: forces of supports
            Amplitudes missing = problem.product(omega, u);
            missing.add(-1, excited[i].forces);
            Amplitudes moved = u;
            if (excited[i].rigid)
              moved.real += *excited[i].rigid;

            std::vector<FrequencyResponse::Value> &values =
              result.values.back()[i];
            unsigned int next = 0;
            const auto   set  = [&](const Tensor<1, 3> &real,
                                 const Tensor<1, 3> &imaginary) {
              for (unsigned int d = 0; d < 3; ++d)
                values[next][d] = {real[d], imaginary[d]};
              ++next;
            };
            LA::Vector real = mesh.ghosted_vector(), imaginary(real);
            real            = moved.real;
            imaginary       = moved.imaginary;
            for (const NamedPoint &point : mesh.points)
              {
                const auto of_real = displacement_at(point, real, mesh),
                           of_imaginary =
                             displacement_at(point, imaginary, mesh);
                for (unsigned int face = 0; face < 2; ++face)
                  set(of_real.global[face], of_imaginary.global[face]);
              }
            const auto of_real = forces_of_supports(
                         mesh, shape.displacement, missing.real),
                       of_imaginary = forces_of_supports(
                         mesh, shape.displacement, missing.imaginary);
            for (unsigned int k = 0; k < of_real.size(); ++k)
              set(of_real[k].force, of_imaginary[k].force);
            for (const ContactOfBody &body : problem.bodies)
              {
                Amplitudes relative = moved;
                if (const auto &moves = request.excitations[i];
                    moves.body && *moves.body == body.number)
                  relative.real -= problem.translations[moves.direction];
                Amplitudes force = zero(mesh);
                body.add_forces(force, relative, omega, request.loss_factor);
                Tensor<1, 3> sum_real, sum_imaginary;
                for (unsigned int d = 0; d < 3; ++d)
                  {
                    sum_real[d] = force.real * problem.translations[d];
                    sum_imaginary[d] =
                      force.imaginary * problem.translations[d];
                  }
                set(sum_real, sum_imaginary);
              }
          }
      }
    return result;
  }
} // namespace Biface
