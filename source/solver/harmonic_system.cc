// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <biface/base/gather.h>
#include <biface/laminate/loss_of_material.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/mass_matrix.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/equations/velocity_matrix.h>
#include <biface/model/forces/dependent_loads.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/solver/fixed_contact_tangent.h>
#include <biface/solver/harmonic_system.h>
#include <biface/solver/linear/complex_solver.h>

namespace Biface
{
  using namespace dealii;

  void
  Amplitudes::add(const Number &factor, const LA::Vector &x)
  {
    real.add(factor.real(), x);
    imaginary.add(factor.imag(), x);
  }


  void
  Amplitudes::add(const Number &factor, const Amplitudes &x)
  {
    add(factor, x.real);
    add(factor * Number(0, 1), x.imaginary);
    for (unsigned int k = 0; k < air.size(); ++k)
      air[k] += factor * x.air[k];
  }


  double
  Amplitudes::norm() const
  {
    return std::hypot(real.l2_norm(), imaginary.l2_norm());
  }


  /** A real matrix in the unknowns of all nodes, supported ones included. */
  struct HarmonicSystem::Part
  {
    std::unique_ptr<const TangentMatrix>  tangent  = {};
    std::unique_ptr<const VelocityMatrix> velocity = {};
    /** See Entries::positions(). */
    mutable std::vector<unsigned int> positions = {};

    const LA::SparseMatrix &
    matrix() const
    {
      return tangent ? tangent->get() : velocity->get();
    }

    /** Add a multiple of the product. */
    void
    vmult_add(Amplitudes       &product,
              const Number     &factor,
              const Amplitudes &x) const
    {
      LA::Vector part(x.real);
      matrix().vmult(part, x.real);
      product.add(factor, part);
      matrix().vmult(part, x.imaginary);
      product.add(factor * Number(0, 1), part);
    }

    /** Call a function with the row on this rank and the column of each entry,
     * both numbers of unknowns, and its value. */
    template <typename Function>
    void
    for_each_entry(const Function &function) const
    {
      const Epetra_CrsMatrix &epetra = matrix().trilinos_matrix();
      for (int row = 0; row < epetra.NumMyRows(); ++row)
        {
          int     n;
          double *values;
          int    *columns;
          epetra.ExtractMyRowView(row, n, values, columns);
          for (int k = 0; k < n; ++k)
            function(row, epetra.GRID(row), epetra.GCID(columns[k]), values[k]);
        }
    }
  };


  /** The entries of the matrix of the free unknowns and of the air, into which
   * multiples of parts are summed; their pattern is found once. */
  class HarmonicSystem::Entries
  {
  public:
    /** @param widest a part whose pattern contains those of all. */
    Entries(const ShellMesh &mesh,
            const Part      &widest,
            const AirMotion &air,
            const bool       symmetric)
      : mesh(mesh), symmetric(symmetric)
    {
      rows.resize(mesh.locally_owned.n_elements());
      widest.for_each_entry(
        [&](const int row, const int i, const int j, const double) {
          rows[row][j] = targets.size();
          targets.emplace_back();
          add_targets(i, j);
        });
      n_of_shell = places.size();
      // what is constrained follows from the others
      for (const auto i : mesh.locally_owned)
        if (mesh.constraints.is_constrained(i))
          add_place(i, i);
      n_constrained = places.size() - n_of_shell;
      values.resize(places.size());
      add_air(air);
    }

    const std::vector<ComplexSolver::Place> &
    get_places() const
    {
      return places;
    }

    /** The positions of the entries of a part among those of the widest. */
    std::vector<unsigned int>
    positions(const Part &part) const
    {
      std::vector<unsigned int> result;
      part.for_each_entry(
        [&](const int row, const int, const int j, const double) {
          result.push_back(rows[row].at(j));
        });
      return result;
    }

    void
    clear()
    {
      std::fill(values.begin(), values.begin() + n_of_shell, 0.);
    }

    void
    add(const Number &factor, const Part &part)
    {
      unsigned int next = 0;
      part.for_each_entry(
        [&](const int, const int, const int, const double value) {
          for (const auto &[target, weight] : targets[part.positions[next]])
            values[target] += factor * (weight * value);
          ++next;
        });
    }

    /** The values after the parts were added.
     * @param of_inertia the factor of the inertia of the air. */
    std::vector<Number> &
    complete(const double of_inertia)
    {
      double largest = 0;
      for (unsigned int k = 0; k < n_of_shell; ++k)
        largest = std::max(largest, std::abs(values[k]));
      std::fill(values.begin() + n_of_shell,
                values.begin() + n_of_shell + n_constrained,
                largest);
      for (const auto &[position, inertia] : inertias)
        values[position] = of_inertia * inertia;
      return values;
    }

  private:
    void
    add_place(const types::global_dof_index row,
              const types::global_dof_index column)
    {
      places.push_back(
        {static_cast<unsigned int>(row), static_cast<unsigned int>(column)});
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
              add_place(i, j);
            }
    }

    /** Add an entry below the diagonal, and the one opposite to it if it is
     * needed. */
    void
    add_pair(const types::global_dof_index row,
             const types::global_dof_index column,
             const double                  value)
    {
      add_place(row, column);
      values.emplace_back(value);
      if (symmetric)
        return;
      add_place(column, row);
      values.emplace_back(value);
    }

    /** Add what does not depend on the frequency: the expansion of a piece with
     * its pressure, and the pressures that accelerate a section. */
    void
    add_air(const AirMotion &air)
    {
      const types::global_dof_index n     = mesh.locally_owned.size(),
                                    n_air = air.compliances.size();
      for (unsigned int c = 0; c < n_air; ++c)
        for (const auto &[dof, value] : air.gradients[c])
          for (const auto &[i, weight] : free_unknowns(dof))
            add_pair(n + c, i, -weight * value);
      // the unknowns of the air are those of the last rank
      if (!AirMotion::is_on_this_rank(mesh.communicator))
        return;
      for (unsigned int c = 0; c < n_air; ++c)
        {
          add_place(n + c, n + c);
          values.emplace_back(-air.compliances[c]);
        }
      for (unsigned int j = 0; j < air.sections.size(); ++j)
        {
          const auto &section = air.sections[j];
          add_pair(n + n_air + j, n + section.from, -1);
          add_pair(n + n_air + j, n + section.to, 1);
          inertias.emplace_back(values.size(), section.inertia);
          add_place(n + n_air + j, n + n_air + j);
          values.emplace_back(0.);
        }
    }

    const ShellMesh &mesh;
    const bool       symmetric;
    /** For each entry of the widest part, the entries to which it is added,
     * with factors. */
    std::vector<std::vector<std::pair<unsigned int, double>>> targets;
    /** First those of the free unknowns, then the diagonal of the constrained
     * ones, then those of the air. */
    std::vector<ComplexSolver::Place> places;
    std::vector<Number>               values;
    unsigned int                      n_of_shell = 0, n_constrained = 0;
    /** The positions of the inertia of sections, with it. */
    std::vector<std::pair<unsigned int, double>> inertias;
    /** By the row of this rank, the position of the entry in a column. */
    std::vector<std::unordered_map<int, unsigned int>> rows;
  };


  namespace
  {
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


    /** A sum over the layers of cell matrices. */
    template <typename Function>
    std::unique_ptr<const TangentMatrix>
    sum_over_layers(const ShellMesh                 &mesh,
                    const AffineConstraints<double> &constraints,
                    const Function                  &add_cell)
    {
      auto       result  = std::make_unique<TangentMatrix>(mesh, constraints);
      LA::Vector nothing = mesh.owned_vector();
      for (const unsigned int c : mesh.layers)
        {
          MixedElement::NodalMatrix of_cell{};
          add_cell(c, of_cell);
          result->add(c, of_cell, MixedElement::NodalVector(), nothing);
        }
      result->compress();
      return result;
    }


    /** Adds the part of the stiffness of cells that is proportional to the
     * moduli of a material. */
    class StiffnessOfMaterial
    {
    public:
      StiffnessOfMaterial(const ShellEquations &equations,
                          const State          &state,
                          const std::string    &material)
        : equations(equations), state(state), material(material)
      {}

      void
      operator()(const unsigned int cell, MixedElement::NodalMatrix &K)
      {
        // the law of a wall is linear in the moduli of its plies but for
        // thickness stress and transverse shear, which are smooth in them
        constexpr double change = 1e-3;

        const ShellMesh   &mesh     = equations.mesh;
        const unsigned int strip    = mesh.cells[cell].strip;
        const Laminate    &laminate = mesh.strips[strip].laminate;
        const auto        &plies    = laminate.get_plies();
        if (std::none_of(plies.begin(), plies.end(), [&](const Ply &ply) {
              return ply.material.name == material;
            }))
          return;
        const auto &[less, more] =
          scaled
            .try_emplace(strip,
                         with_scaled_material(laminate, material, 1 - change),
                         with_scaled_material(laminate, material, 1 + change))
            .first->second;
        const InternalForces &internal = equations.internal_forces();
        internal.add_law(state, cell, more, 0.5 / change, K);
        internal.add_law(state, cell, less, -0.5 / change, K);
      }

    private:
      const ShellEquations &equations;
      const State          &state;
      const std::string     material;
      /** By the strip, its laminate with smaller and larger moduli. */
      std::map<unsigned int, std::pair<Laminate, Laminate>> scaled;
    };
  } // namespace


  HarmonicSystem::HarmonicSystem(ShellEquations           &equations,
                                 const ContactInteraction &contact,
                                 const AirColumn          *air_column,
                                 const State              &given,
                                 const Loads              &loads,
                                 const HarmonicLosses     &losses,
                                 TimerOutput              &timer)
    : equations(equations)
    , mesh(equations.mesh)
    , losses(losses)
    , shape_of_tangent(given)
    , none(mesh.locally_relevant)
  {
    none.close();
    const auto motions = rigid_motions(mesh);
    for (unsigned int i = 0; i < 3; ++i)
      {
        translations.push_back(mesh.owned_vector());
        std::copy(
          motions[i].begin(), motions[i].end(), translations.back().begin());
      }

    // where stresses relax, the elastic law, which is the instantaneous one
    const InternalForces &internal = equations.internal_forces();
    State                 state    = given;
    state.terms.erase(internal.name());
    shape_of_tangent = internal.in_shape_of_tangent(state);

    bool symmetric = false;
    {
      FixedContactTangent tangent(equations, contact, timer);
      LA::SparseMatrix    with_supports;
      tangent.assemble(state, loads, with_supports);
      symmetric = tangent.is_symmetric(loads, with_supports) && !loads.rolling;
      tangent.add_contact_stiffness(state, loads, with_supports);
      for (const RigidMotion &motion :
           tangent.neutral_motions(state, loads, with_supports))
        if (free_motion.empty())
          free_motion = motion.name;
    }

    const Loads alone = FixedContactTangent::without_bodies(loads);
    const auto [of_stresses, now] =
      FixedContactTangent::of_tangent(state, alone);
    K = std::make_unique<const Part>(
      Part{equations.tangent_with(none, of_stresses, now)});
    M = std::make_unique<const Part>(Part{
      sum_over_layers(mesh, none, [&](const unsigned int c, auto &of_cell) {
        of_cell = cell_mass(mesh, mesh.cells[c]);
      })});
    if (loads.rolling)
      G = std::make_unique<const Part>(Part{
        nullptr,
        std::make_unique<const VelocityMatrix>(contact, state, alone, none)});
    if (losses.damping_of_stiffness > 0)
      K_0 = std::make_unique<const Part>(Part{
        sum_over_layers(mesh, none, [&](const unsigned int c, auto &of_cell) {
          internal.add_damping(shape_of_tangent, c, of_cell);
        })});
    for (const auto &[name, loss] : losses_on_all(mesh, losses.temperature))
      {
        StiffnessOfMaterial add(equations, shape_of_tangent, name);
        materials.emplace_back(
          loss,
          std::make_unique<const Part>(Part{sum_over_layers(
            mesh, none, [&](const unsigned int c, auto &of_cell) {
              add(c, of_cell);
            })}));
      }
    set_contact(contact, state, loads);

    if (air_column)
      // the waves contain the stiffness of the gas
      air = air_column->about(
        given, equations.with_dependent_loads(given, loads).pressure);
    else
      {
        std::vector<DependentLoads> dependent;
        for (const ForceTerm *term : equations.get_terms())
          term->add_dependent_loads(shape_of_tangent, alone, dependent);
        for (const DependentLoads &load : dependent)
          low_rank.push_back(
            {equations.nodal_load_rates(shape_of_tangent, alone, load.rates),
             load.gradient});
      }

    // a wheel that rolls has the entries of its contact
    const Part &widest =
      (loads.rolling && !bodies.empty() ? *bodies[0].stiffness[0].second : *K);
    entries = std::make_unique<Entries>(mesh, widest, air, symmetric);
    for_each_part([&](const Number &, const Part &part) {
      if (part.positions.empty())
        part.positions = entries->positions(part);
    });
    const bool         is_last = AirMotion::is_on_this_rank(mesh.communicator);
    const unsigned int n_of_air =
      (is_last ? air.compliances.size() + air.sections.size() : 0);
    solver = std::make_unique<ComplexSolver>(mesh.communicator,
                                             mesh.locally_owned.n_elements() +
                                               n_of_air,
                                             entries->get_places(),
                                             symmetric);
  }


  HarmonicSystem::~HarmonicSystem() = default;


  void
  HarmonicSystem::set_contact(const ContactInteraction &contact,
                              const State              &state,
                              const Loads              &loads)
  {
    const auto keep = [this](Part part) {
      parts_of_bodies.push_back(std::make_unique<const Part>(std::move(part)));
      return parts_of_bodies.back().get();
    };
    for (const ContactPair *pair : contact.present(loads))
      {
        ContactOfBody of_body{pair->number, pair->name, {}, {}};
        if (FixedContactTangent::rolls_with_friction(loads))
          {
            // what the only body adds to the whole
            const auto [of_stresses, now] =
              FixedContactTangent::of_tangent(state, loads);
            of_body.stiffness = {
              {1., keep({equations.tangent_with(none, of_stresses, now)})},
              {-1., K.get()}};
            of_body.velocity = {{1.,
                                 keep({nullptr,
                                       std::make_unique<const VelocityMatrix>(
                                         contact, state, loads, none)})},
                                {-1., G.get()}};
          }
        else
          {
            auto stiffness = std::make_unique<TangentMatrix>(mesh, none);
            FixedContactTangent::add_stiffness_of(
              *pair, state, loads, *stiffness);
            stiffness->compress();
            of_body.stiffness = {{1., keep({std::move(stiffness)})}};
          }
        bodies.push_back(of_body);
      }
  }


  template <typename Function>
  void
  HarmonicSystem::for_each_part(const Function &function) const
  {
    const Number of_stiffness(1, losses.loss_factor), of_velocity(0, omega);
    function(of_stiffness, *K);
    function(Number(-omega * omega, omega * losses.damping_of_mass), *M);
    if (G)
      function(of_velocity, *G);
    if (K_0)
      function(losses.damping_of_stiffness * of_velocity, *K_0);
    for (const auto &[loss, part] : materials)
      function(loss.factor(omega) - 1., *part);
    for (const ContactOfBody &body : bodies)
      {
        for (const auto &[sign, part] : body.stiffness)
          function(sign * of_stiffness, *part);
        for (const auto &[sign, part] : body.velocity)
          function(sign * of_velocity, *part);
      }
  }


  Amplitudes
  HarmonicSystem::zero() const
  {
    return {mesh.owned_vector(),
            mesh.owned_vector(),
            std::vector<Number>(air.compliances.size() + air.sections.size())};
  }


  double
  HarmonicSystem::factor_of_inertia_of_air() const
  {
    // relative to the first wave
    constexpr double negligible = 1e-10;

    return -std::max(omega * omega, negligible * air.first_wave());
  }


  std::string
  HarmonicSystem::set_frequency(const double frequency)
  {
    omega = 2 * numbers::PI * frequency;
    if (omega == 0 && !free_motion.empty())
      return "nothing resists " + free_motion;
    entries->clear();
    for_each_part([&](const Number &factor, const Part &part) {
      entries->add(factor, part);
    });
    return solver->factorize(
      entries->complete(has_air() ? factor_of_inertia_of_air() : 0));
  }


  Amplitudes
  HarmonicSystem::product(const Amplitudes &u) const
  {
    Amplitudes result = zero();
    for_each_part([&](const Number &factor, const Part &part) {
      part.vmult_add(result, factor, u);
    });
    for (const RankOne &part : low_rank)
      result.add(-(u * part.gradient), part.forces);
    // the pressure of each piece pushes its wall
    const unsigned int  n = air.compliances.size();
    std::vector<Number> expansion(n);
    for (unsigned int c = 0; c < n; ++c)
      for (const auto &[dof, value] : air.gradients[c])
        {
          result.real(dof) -= value * u.air[c].real();
          result.imaginary(dof) -= value * u.air[c].imag();
          expansion[c] += value * Number(u.real(dof), u.imaginary(dof));
        }
    Utilities::MPI::sum(expansion, mesh.communicator, expansion);
    for (unsigned int c = 0; c < n; ++c)
      result.air[c] = -expansion[c] - air.compliances[c] * u.air[c];
    const double of_inertia = (has_air() ? factor_of_inertia_of_air() : 0);
    for (unsigned int j = 0; j < air.sections.size(); ++j)
      {
        const AirMotion::Section &section = air.sections[j];
        result.air[section.from] -= u.air[n + j];
        result.air[section.to] += u.air[n + j];
        result.air[n + j] = of_inertia * section.inertia * u.air[n + j] -
                            u.air[section.from] + u.air[section.to];
      }
    for (LA::Vector *part : {&result.real, &result.imaginary})
      part->compress(VectorOperation::add);
    return result;
  }


  void
  HarmonicSystem::condense(Amplitudes &forces) const
  {
    for (LA::Vector *part : {&forces.real, &forces.imaginary})
      {
        mesh.condense(*part);
        part->compress(VectorOperation::add);
        mesh.constraints.set_zero(*part);
      }
  }


  bool
  HarmonicSystem::solve_by_factors(std::vector<Amplitudes> &x) const
  {
    const unsigned int n = x.size(), m = low_rank.size(),
                       n_own = mesh.locally_owned.n_elements();
    const bool is_last       = AirMotion::is_on_this_rank(mesh.communicator);
    std::vector<ComplexSolver::Vector> b;
    const auto                         add_own = [&](const Amplitudes &forces) {
      b.emplace_back();
      for (unsigned int k = 0; k < n_own; ++k)
        b.back().emplace_back(forces.real.begin()[k],
                              forces.imaginary.begin()[k]);
      if (is_last)
        b.back().insert(b.back().end(), forces.air.begin(), forces.air.end());
    };
    const auto of_own = [&](const ComplexSolver::Vector &own) {
      Amplitudes result = zero();
      for (unsigned int k = 0; k < n_own; ++k)
        {
          result.real.begin()[k]      = own[k].real();
          result.imaginary.begin()[k] = own[k].imag();
        }
      for (LA::Vector *part : {&result.real, &result.imaginary})
        mesh.constraints.distribute(*part);
      if (is_last)
        std::copy(own.begin() + n_own, own.end(), result.air.begin());
      Utilities::MPI::sum(result.air, mesh.communicator, result.air);
      return result;
    };

    for (const Amplitudes &forces : x)
      add_own(forces);
    for (const RankOne &part : low_rank)
      {
        Amplitudes forces = zero();
        forces.add(1, part.forces);
        condense(forces);
        add_own(forces);
      }
    if (!solver->solve(b))
      return false;
    std::vector<Amplitudes> per_load;
    for (unsigned int k = 0; k < m; ++k)
      per_load.push_back(of_own(b[n + k]));
    // the Woodbury formula
    FullMatrix<Number> inverse(m, m);
    for (unsigned int k = 0; k < m; ++k)
      for (unsigned int l = 0; l < m; ++l)
        inverse(k, l) = Number(k == l) - per_load[l] * low_rank[k].gradient;
    if (m > 0)
      inverse.gauss_jordan();
    for (unsigned int i = 0; i < n; ++i)
      {
        x[i] = of_own(b[i]);
        std::vector<Number> work;
        for (const RankOne &part : low_rank)
          work.push_back(x[i] * part.gradient);
        for (unsigned int k = 0; k < m; ++k)
          for (unsigned int l = 0; l < m; ++l)
            x[i].add(inverse(k, l) * work[l], per_load[k]);
      }
    return true;
  }


  std::string
  HarmonicSystem::solve(std::vector<Amplitudes> &x) const
  {
    // parts of the right-hand side that may be left, before and after a
    // correction
    constexpr double exact = 1e-10, sufficient = 1e-6;

    for (Amplitudes &forces : x)
      condense(forces);
    const std::vector<Amplitudes> b = x;
    if (!solve_by_factors(x))
      return "the matrix is singular";
    const auto rest = [&](double &largest) {
      std::vector<Amplitudes> result = b;
      largest                        = 0;
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          Amplitudes forces = product(x[i]);
          condense(forces);
          result[i].add(-1, forces);
          if (const double norm = b[i].norm(); norm > 0)
            largest = std::max(largest, result[i].norm() / norm);
        }
      return result;
    };
    double                  largest;
    std::vector<Amplitudes> correction = rest(largest);
    if (largest > exact)
      {
        if (!solve_by_factors(correction))
          return "the matrix is singular";
        for (unsigned int i = 0; i < x.size(); ++i)
          x[i].add(1, correction[i]);
        rest(largest);
      }
    return largest < sufficient
             ? ""
             : "the solution is not exact, as in a resonance "
               "without losses";
  }


  void
  HarmonicSystem::add_inertia(const LA::Vector &displacement,
                              Amplitudes       &forces) const
  {
    Amplitudes moves = zero();
    moves.add(1, displacement);
    M->vmult_add(
      forces, Number(omega * omega, -omega * losses.damping_of_mass), moves);
    if (G)
      G->vmult_add(forces, Number(0, -omega), moves);
  }


  void
  HarmonicSystem::add_inertia_of_air(const unsigned int direction,
                                     Amplitudes        &forces) const
  {
    if (!has_air())
      return;
    const unsigned int n          = air.compliances.size();
    const double       of_inertia = factor_of_inertia_of_air();
    for (unsigned int j = 0; j < air.sections.size(); ++j)
      {
        const AirMotion::Section &section = air.sections[j];
        forces.air[n + j] -= of_inertia * section.inertia * section.area *
                             section.direction[direction];
      }
  }


  void
  HarmonicSystem::add_contact(const unsigned int body,
                              const Amplitudes  &relative,
                              const double       factor,
                              Amplitudes        &forces) const
  {
    for (const auto &[sign, part] : bodies[body].stiffness)
      part->vmult_add(
        forces, -factor * sign * Number(1, losses.loss_factor), relative);
    for (const auto &[sign, part] : bodies[body].velocity)
      part->vmult_add(forces, -factor * sign * Number(0, omega), relative);
  }


  std::array<HarmonicSystem::Number, 3>
  HarmonicSystem::force_of_rim(const Amplitudes                  &u,
                               const std::optional<unsigned int> &wheel) const
  {
    const unsigned int    n = air.compliances.size();
    std::array<Number, 3> force{};
    // the rate of the momentum of the air, less what the wall gives
    for (unsigned int j = 0; j < air.sections.size(); ++j)
      {
        const AirMotion::Section &section = air.sections[j];
        Number                    moved   = u.air[n + j];
        if (wheel)
          moved += section.area * section.direction[*wheel];
        for (unsigned int d = 0; d < 3; ++d)
          force[d] -= omega * omega * section.inertia * section.area *
                      section.direction[d] * moved;
      }
    for (unsigned int d = 0; d < 3; ++d)
      {
        std::vector<double> on_wall(n);
        for (unsigned int c = 0; c < n; ++c)
          for (const auto &[dof, value] : air.gradients[c])
            on_wall[c] += value * translations[d](dof);
        Utilities::MPI::sum(on_wall, mesh.communicator, on_wall);
        for (unsigned int c = 0; c < n; ++c)
          force[d] += u.air[c] * on_wall[c];
      }
    return force;
  }
} // namespace Biface
