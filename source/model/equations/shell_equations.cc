// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/equations/symmetry.h>
#include <biface/model/forces/dependent_loads.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  using namespace dealii;

  ShellEquations::ShellEquations(const ShellMesh &mesh, ForceTerms other_terms)
    : EquationSystem(mesh)
    , internal(mesh)
    , other_terms(std::move(other_terms))
    , terms{&internal}
    , constraints(mesh.constraints)
    , rhs(mesh.owned_vector())
  {
    // first those that linear theory linearizes, so that a range of the list
    // contains them
    for (const bool linearized : {true, false})
      {
        for (const auto &term : this->other_terms)
          if (term->is_linearized() == linearized)
            terms.push_back(term.get());
        if (linearized)
          n_linearized = terms.size();
      }
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      elements.push_back({&mesh.cells[c], c});
    // terms may act on elements of their own, such as the sections at an edge
    // with moments
    for (const ForceTerm *term : terms)
      {
        unsigned int index = 0;
        for (const Cell *cell : term->elements())
          elements.push_back({cell, index++, term});
      }
  }


  double
  ShellEquations::strain_energy(const State &state) const
  {
    double of_terms = 0;
    for (const auto &term : other_terms)
      of_terms += term->stored_energy(state);
    return internal.strain_energy(state) +
           Utilities::MPI::sum(of_terms, mesh.communicator);
  }


  double
  ShellEquations::dissipated_energy(const State &state) const
  {
    double sum = 0;
    for (const ForceTerm *term : terms)
      sum += term->dissipated_energy(state);
    return Utilities::MPI::sum(sum, mesh.communicator);
  }


  namespace
  {
    /** In linear strain theory, the loads that turn with the shell, and the
     * change since then of those that do not. */
    std::pair<Loads, LoadRates>
    linearized(const Loads &loads)
    {
      Loads start;
      start.rolling = loads.rolling;
      LoadRates change;
      change.factors.assign(loads.factors.size(), 0.);
      start.pressure = loads.pressure;
      start.factors  = loads.factors;
      if (const auto &at = loads.linearized_at)
        {
          start.pressure  = at->pressure;
          change.pressure = loads.pressure - at->pressure;
          for (unsigned int i = 0; i < loads.factors.size(); ++i)
            {
              start.factors[i]  = factor_at(at->factors, i);
              change.factors[i] = loads.factors[i] - start.factors[i];
            }
        }
      return {start, change};
    }
  } // namespace


  void
  ShellEquations::add_forces(const unsigned int     begin,
                             const unsigned int     end,
                             const Element         &element,
                             const State           &state,
                             const Loads           &loads,
                             ForceTerm::CellForces &forces) const
  {
    const Cell        &cell = *element.cell;
    const unsigned int c    = element.index;
    const auto         V    = mesh.cell_values(state.displacement, cell);
    const auto        &base = state.linearization_point;
    if (base && begin < n_linearized)
      {
        const auto V_0 = mesh.cell_values(base->displacement, cell);
        const auto dV  = V - V_0;
        // section 7 of doc/theory.md: the forces about the state at the start
        // of the stage, with their tangent there; laws of cords that go slack
        // remain what they are. The product of a change of the loads and a
        // displacement is of second order
        const auto [start, change] = linearized(loads);
        for (unsigned int t = std::max(begin, 1u); t < end; ++t)
          if (acts_on(*terms[t], element, *base, start))
            {
              const ForceTerm::CellState at{c, cell, V_0, *base, start};
              terms[t]->add(at, forces);
              terms[t]->add_load_derivative(at, change, forces.load);
            }
        // so far the tangent is that of the loads; internal forces, which come
        // last, linearize themselves
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
            forces.force[i] -= forces.tangent[i][j] * dV[j];
        // the first term: the internal forces
        if (begin == 0 && acts_on(internal, element, *base, loads))
          internal.add_linearized({c, cell, V_0, *base, loads}, dV, forces);
        forces.square = forces.force.norm_square();
      }
    else if (state.step)
      add_forces_over_step(begin, end, element, state, loads, forces);
    else
      for (unsigned int t = begin; t < end; ++t)
        if (acts_on(*terms[t], element, state, loads))
          terms[t]->add({c, cell, V, state, loads}, forces);
  }


  void
  ShellEquations::add_forces_over_step(const unsigned int     begin,
                                       const unsigned int     end,
                                       const Element         &element,
                                       const State           &state,
                                       const Loads           &loads,
                                       ForceTerm::CellForces &forces) const
  {
    const StepInTime  &step = *state.step;
    const Cell        &cell = *element.cell;
    const unsigned int c    = element.index;
    const auto         V    = mesh.cell_values(state.displacement, cell);
    const auto         V_0  = mesh.cell_values(step.start.displacement, cell);
    for (unsigned int t = begin; t < end; ++t)
      if (acts_on(*terms[t], element, state, loads))
        terms[t]->add_over_step({c, cell, V_0, step.start, step.loads_at_start},
                                {c, cell, V, state, loads},
                                forces);
  }


  void
  ShellEquations::sum_forces(const Element         &element,
                             const State           &state,
                             const Loads           &loads,
                             ForceTerm::CellForces &forces) const
  {
    forces.clear();
    add_forces(0, n_linearized, element, state, loads, forces);
    add_forces(n_linearized, terms.size(), element, state, loads, forces);
  }


  namespace
  {
    /** The loads that exert forces: over a step in time, those in its middle,
     * while supports are where they are at its end. */
    Loads
    acting_loads(const State &state, const Loads &loads)
    {
      return state.step ? state.step->over_step(loads) : loads;
    }
  } // namespace


  std::vector<const Cell *>
  ShellEquations::of_terms() const
  {
    std::vector<const Cell *> result;
    for (const Element &element : elements)
      if (element.owner)
        result.push_back(element.cell);
    return result;
  }


  void
  ShellEquations::assemble(const State &state, const Loads &loads_at_end)
  {
    update_constraints(state, loads_at_end);
    const Loads                      loads = acting_loads(state, loads_at_end);
    std::vector<ForceTerm::Coupling> couplings;
    for (const ForceTerm *term : terms)
      term->add_couplings(state, loads, couplings);
    // all ranks take part in building a matrix, even if only one of them has
    // new couplings
    if (Utilities::MPI::logical_or(!matrix || !matrix->has(couplings),
                                   mesh.communicator))
      {
        // Nodes come and go: a pattern that has those of earlier states need
        // not be analyzed again.
        for (const ForceTerm::Coupling &coupling : couplings)
          if (!matrix || !matrix->has({coupling}))
            {
              known_couplings.push_back(coupling);
              known_couplings.back().stiffness.reinit(0, 0);
            }
        matrix = std::make_unique<TangentMatrix>(
          mesh, constraints, known_couplings, of_terms());
      }
    matrix->clear();
    rhs = 0;
    for (const ForceTerm::Coupling &coupling : couplings)
      matrix->add(coupling);

    // loads on their own: their norm and that of the forces that cancel are the
    // scale of the residual
    LA::Vector load = mesh.owned_vector();
    for (const ForceTerm *term : terms)
      term->add_dead_forces({loads.pressure, loads.factors, 0}, load);
    LA::Vector constant = mesh.owned_vector();
    internal.add_constant_forces(state, constant);
    mesh.condense(constant);

    double                square = 0;
    ForceTerm::CellForces forces;
    for (const Element &element : elements)
      {
        sum_forces(element, state, loads, forces);
        square += forces.square;
        if (element.owner)
          matrix->add(*element.cell, forces.tangent, forces.force, rhs);
        else
          matrix->add(element.index, forces.tangent, forces.force, rhs);
        if (forces.load.norm_square() > 0)
          mesh.add_nodal_forces(*element.cell, forces.load, load);
      }
    matrix->compress();
    rhs.compress(VectorOperation::add);
    load.compress(VectorOperation::add);
    // what supports take up needs no balance and does not count in the norms
    mesh.condense(load);
    LA::Vector coupled = coupled_forces(state, loads, square);
    mesh.condense(coupled);

    rhs += load;
    rhs += constant;
    rhs += coupled;
    const double load_square     = load.norm_sqr(),
                 constant_square = constant.norm_sqr();
    given_forces                 = std::sqrt(load_square + constant_square);
    force_scale = std::sqrt(Utilities::MPI::sum(square, mesh.communicator) +
                            load_square + constant_square);
  }


  std::unique_ptr<TangentMatrix>
  ShellEquations::tangent_with(const AffineConstraints<double> &constraints,
                               const State                     &state,
                               const Loads                     &loads) const
  {
    std::vector<ForceTerm::Coupling> couplings;
    for (const ForceTerm *term : terms)
      term->add_couplings(state, loads, couplings);
    // these constraints leave other entries than those of the supports
    auto result =
      std::make_unique<TangentMatrix>(mesh, constraints, couplings, of_terms());
    for (const ForceTerm::Coupling &coupling : couplings)
      result->add(coupling);
    LA::Vector            nothing = mesh.owned_vector();
    ForceTerm::CellForces forces;
    for (const Element &element : elements)
      {
        sum_forces(element, state, loads, forces);
        const MixedElement::NodalVector none;
        if (element.owner)
          result->add(*element.cell, forces.tangent, none, nothing);
        else
          result->add(element.index, forces.tangent, none, nothing);
      }
    result->compress();
    return result;
  }


  ShellEquations::Balance
  ShellEquations::balance(const State &state, const Loads &loads_at_end) const
  {
    const Loads loads = acting_loads(state, loads_at_end);
    LA::Vector  load  = mesh.owned_vector();
    for (const ForceTerm *term : terms)
      term->add_dead_forces({loads.pressure, loads.factors, 0}, load);
    LA::Vector constant = mesh.owned_vector();
    internal.add_constant_forces(state, constant);

    LA::Vector sum = load;
    sum += constant;
    double                square = 0;
    ForceTerm::CellForces forces;
    // linearized forces need their tangent
    forces.with_tangent = state.linearization_point != nullptr;
    for (const Element &element : elements)
      {
        sum_forces(element, state, loads, forces);
        square += forces.square;
        mesh.add_nodal_forces(*element.cell, forces.force + forces.load, sum);
        if (forces.load.norm_square() > 0)
          mesh.add_nodal_forces(*element.cell, forces.load, load);
      }
    sum.compress(VectorOperation::add);
    load.compress(VectorOperation::add);
    sum += coupled_forces(state, loads, square);
    for (LA::Vector *part : {&sum, &load, &constant})
      mesh.condense(*part);
    const double load_square     = load.norm_sqr(),
                 constant_square = constant.norm_sqr();
    return {sum,
            std::sqrt(Utilities::MPI::sum(square, mesh.communicator) +
                      load_square + constant_square),
            std::sqrt(load_square + constant_square)};
  }


  LA::Vector
  ShellEquations::coupled_forces(const State &state,
                                 const Loads &loads,
                                 double      &square) const
  {
    LA::Vector result = mesh.owned_vector();
    for (const ForceTerm *term : terms)
      term->add_coupled_forces(state, loads, result);
    result.compress(VectorOperation::add);
    for (const double force : result)
      square += force * force;
    return result;
  }


  void
  ShellEquations::assemble_residual(const State &state, const Loads &loads)
  {
    update_constraints(state, loads);
    Balance balance = this->balance(state, loads);
    // after an assignment, adding to a vector is collective, but a rank without
    // cells adds nothing
    rhs.swap(balance.sum);
    force_scale  = balance.scale;
    given_forces = balance.given;
  }


  void
  ShellEquations::add_contact(const State &state, const Loads &loads)
  {
    LA::Vector            sum    = mesh.owned_vector();
    double                square = 0;
    ForceTerm::CellForces forces;
    for (const unsigned int c : mesh.walls)
      for (unsigned int t = n_linearized; t < terms.size(); ++t)
        if (terms[t]->source() == ForceTerm::Source::ground &&
            terms[t]->acts_on(c, state, loads))
          {
            forces.clear();
            add_forces(t, t + 1, elements[c], state, loads, forces);
            square += forces.square;
            matrix->add(c, forces.tangent, forces.force, sum);
          }
    matrix->compress();
    sum.compress(VectorOperation::add);
    rhs += sum;
    force_scale = std::hypot(
      force_scale, std::sqrt(Utilities::MPI::sum(square, mesh.communicator)));
  }


  LA::Vector
  ShellEquations::out_of_balance_forces(const State &state,
                                        const Loads &loads) const
  {
    return balance(state, loads).sum;
  }


  namespace
  {
    double
    value_of(const PrescribedDisplacement &prescribed, const Loads &loads)
    {
      double value = 0;
      for (unsigned int i = 0; i < prescribed.values.size(); ++i)
        // after a start from prestress, prescribed displacements count from the
        // new shape
        value +=
          (factor_at(loads.factors, i) - factor_at(loads.factors_of_shape, i)) *
          prescribed.values[i];
      return value;
    }
  } // namespace


  void
  ShellEquations::move_supports(State &state, const Loads &loads) const
  {
    // the constraints of the mesh are homogeneous, prescribed values are added
    // to what they give
    LA::Vector displacement = owned_part(state.displacement);
    mesh.constraints.distribute(displacement);
    for (const PrescribedDisplacement &p : mesh.prescribed)
      if (mesh.locally_owned.is_element(p.dof))
        displacement(p.dof) += value_of(p, loads);
    displacement.compress(VectorOperation::add);
    state.displacement = displacement;
  }


  bool
  ShellEquations::is_symmetric(const Loads &loads) const
  {
    return std::all_of(terms.begin(), terms.end(), [&](const ForceTerm *term) {
      return term->is_symmetric(loads);
    });
  }


  bool
  ShellEquations::has_unsymmetric_contact(const Loads &loads) const
  {
    return std::any_of(terms.begin(), terms.end(), [&](const ForceTerm *term) {
      return term->source() == ForceTerm::Source::ground &&
             !term->is_symmetric(loads);
    });
  }


  bool
  ShellEquations::is_symmetric_but_for_loads(const Loads &loads) const
  {
    return std::all_of(terms.begin(), terms.end(), [&](const ForceTerm *term) {
      return term->source() == ForceTerm::Source::loads ||
             term->is_symmetric(loads);
    });
  }


  bool
  ShellEquations::is_symmetric(const Loads            &loads,
                               const LA::SparseMatrix &tangent) const
  {
    // loads that follow the shell have a potential or not by what happens at
    // the edges: only the tangent itself tells
    return !has_unsymmetric_contact(loads) &&
           (is_symmetric(loads) || Biface::is_symmetric(mesh, tangent));
  }


  void
  ShellEquations::start_stage(const Loads &loads, State &state) const
  {
    for (const ForceTerm *term : terms)
      term->start_stage(loads, state);
  }


  void
  ShellEquations::commit_step(const State        &before,
                              const Loads        &loads,
                              const TimeInterval &time,
                              State              &after) const
  {
    for (const ForceTerm *term : terms)
      term->commit_step(before, loads, time, after);
  }


  std::string
  ShellEquations::prepare(const Loads &loads, State &state) const
  {
    std::string first;
    for (const ForceTerm *term : terms)
      if (const std::string why = term->prepare(loads, state); first.empty())
        first = why;
    return first;
  }


  Loads
  ShellEquations::with_dependent_loads(const State &state,
                                       const Loads &loads) const
  {
    Loads result = loads;
    for (const ForceTerm *term : terms)
      term->set_dependent_loads(state, result);
    return result;
  }


  std::vector<EquationSystem::RankOne>
  ShellEquations::low_rank_part(const State &state, const Loads &loads) const
  {
    std::vector<DependentLoads> dependent;
    for (const ForceTerm *term : terms)
      term->add_dependent_loads(state, loads, dependent);
    std::vector<RankOne> parts;
    for (const DependentLoads &load : dependent)
      parts.push_back(
        {load_direction(state, loads, load.rates), load.gradient});
    return parts;
  }


  LA::Vector
  ShellEquations::load_direction(const State     &state,
                                 const Loads     &loads,
                                 const LoadRates &rates) const
  {
    LA::Vector direction = nodal_load_rates(state, loads, rates);
    mesh.condense(direction);
    return direction;
  }


  LA::Vector
  ShellEquations::nodal_load_rates(const State     &state,
                                   const Loads     &loads_at_end,
                                   const LoadRates &rates) const
  {
    Assert(!state.linearization_point, ExcNotImplemented());
    const Loads loads     = acting_loads(state, loads_at_end);
    LA::Vector  direction = mesh.owned_vector();
    for (const ForceTerm *term : terms)
      term->add_dead_forces(rates, direction);
    for (const Element &element : elements)
      {
        MixedElement::NodalVector force;
        add_load_derivative(element, state, loads, rates, force);
        if (force.norm_square() > 0)
          mesh.add_nodal_forces(*element.cell, force, direction);
      }
    for (const ForceTerm *term : terms)
      term->add_load_derivative_of_couplings(state, loads, rates, direction);
    direction.compress(VectorOperation::add);
    return direction;
  }


  void
  ShellEquations::add_load_derivative(const Element             &element,
                                      const State               &state,
                                      const Loads               &loads,
                                      const LoadRates           &rates,
                                      MixedElement::NodalVector &force) const
  {
    const Cell       &cell = *element.cell;
    const StepInTime *step = state.step.get();
    const auto        V    = mesh.cell_values(state.displacement, cell);
    // in a step in time, forces depend on both of its ends
    const auto V_0 =
      (step ? mesh.cell_values(step->start.displacement, cell) : V);
    for (const ForceTerm *term : terms)
      if (acts_on(*term, element, state, loads))
        {
          const ForceTerm::CellState at{element.index, cell, V, state, loads};
          if (step)
            term->add_load_derivative_over_step(
              {element.index, cell, V_0, step->start, step->loads_at_start},
              at,
              rates,
              force);
          else
            term->add_load_derivative(at, rates, force);
        }
  }


  void
  ShellEquations::for_each_moved(
    const LA::Vector                                               &moved,
    const State                                                    &state,
    const Loads                                                    &loads,
    const std::function<void(const Element                   &element,
                             const MixedElement::NodalVector &moved,
                             const ForceTerm::CellForces &forces)> &function)
    const
  {
    ForceTerm::CellForces forces;
    for (const Element &element : elements)
      {
        const auto of_element = mesh.cell_values(moved, *element.cell);
        if (of_element.norm_square() == 0)
          continue;
        sum_forces(element, state, loads, forces);
        function(element, of_element, forces);
      }
  }


  namespace
  {
    /** The displacements of the supports for the given rates of the loads, with
     * the entries of all nodes of this rank. */
    LA::Vector
    motion_of_supports(const ShellMesh &mesh, const LoadRates &rates)
    {
      LA::Vector owned = mesh.owned_vector();
      for (const PrescribedDisplacement &p : mesh.prescribed)
        if (mesh.locally_owned.is_element(p.dof))
          for (unsigned int i = 0; i < p.values.size(); ++i)
            owned(p.dof) += factor_at(rates.factors, i) * p.values[i];
      owned.compress(VectorOperation::add);
      LA::Vector result = mesh.ghosted_vector();
      result            = owned;
      return result;
    }
  } // namespace


  std::optional<EquationSystem::MovedSupports>
  ShellEquations::moved_supports(const State     &state,
                                 const Loads     &loads_at_end,
                                 const LoadRates &rates) const
  {
    const LA::Vector motion = motion_of_supports(mesh, rates);
    if (motion.linfty_norm() == 0)
      return {};
    MovedSupports result{owned_part(motion), mesh.owned_vector()};
    for_each_moved(motion,
                   state,
                   acting_loads(state, loads_at_end),
                   [&](const Element                   &element,
                       const MixedElement::NodalVector &moved,
                       const ForceTerm::CellForces     &forces) {
                     MixedElement::NodalVector force;
                     for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
                       for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
                         force[i] -= forces.tangent[i][j] * moved[j];
                     mesh.add_nodal_forces(*element.cell, force, result.forces);
                   });
    result.forces.compress(VectorOperation::add);
    mesh.condense(result.forces);
    return result;
  }


  LinearizedResultant
  ShellEquations::power_of_supports(const State                  &state,
                                    const Loads                  &loads_at_end,
                                    const LoadRates              &motion,
                                    const std::vector<LoadRates> &rates) const
  {
    const Loads         loads = acting_loads(state, loads_at_end);
    const LA::Vector    moved = motion_of_supports(mesh, motion);
    const LA::Vector    owned = owned_part(moved);
    LinearizedResultant result;
    result.gradient = mesh.owned_vector();

    // supports exert the opposite of all other forces: the value, its
    // magnitude, then the derivatives by the loads
    std::vector<double> sums(2 + rates.size());
    for_each_moved(
      moved,
      state,
      loads,
      [&](const Element                   &element,
          const MixedElement::NodalVector &motion_of_element,
          const ForceTerm::CellForces     &forces) {
        MixedElement::NodalVector on_nodes = forces.force + forces.load;
        // what balances initial resultants is a part of the forces of the
        // supports, see forces_on_shell()
        if (!element.owner && element.cell->is_layer)
          on_nodes -= internal.initial_forces(state, element.index);
        const double power = -(motion_of_element * on_nodes);
        sums[0] += power;
        sums[1] += std::abs(power);
        MixedElement::NodalVector gradient;
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
            gradient[j] += motion_of_element[i] * forces.tangent[i][j];
        mesh.add_nodal_forces(*element.cell, gradient, result.gradient);
        for (unsigned int k = 0; k < rates.size(); ++k)
          {
            MixedElement::NodalVector change;
            add_load_derivative(element, state, loads, rates[k], change);
            sums[2 + k] -= motion_of_element * change;
          }
      });
    Utilities::MPI::sum(sums, mesh.communicator, sums);
    result.gradient.compress(VectorOperation::add);

    const auto power_of_dead_forces = [&](const LoadRates &of_loads) {
      LA::Vector dead = mesh.owned_vector();
      for (const ForceTerm *term : terms)
        term->add_dead_forces(of_loads, dead);
      dead.compress(VectorOperation::add);
      return -(owned * dead);
    };
    double       square = 0;
    const double others =
      power_of_dead_forces({loads.pressure, loads.factors, 0}) -
      owned * coupled_forces(state, loads, square);
    result.value     = sums[0] + others;
    result.magnitude = sums[1] + std::abs(others);
    for (unsigned int k = 0; k < rates.size(); ++k)
      result.per_load.push_back(sums[2 + k] + power_of_dead_forces(rates[k]));

    // the loads that follow from the displacements of the whole shell
    std::vector<DependentLoads> dependent;
    for (const ForceTerm *term : terms)
      term->add_dependent_loads(state, loads, dependent);
    for (const DependentLoads &load : dependent)
      result.gradient.add(
        -(owned * nodal_load_rates(state, loads_at_end, load.rates)),
        load.gradient);
    return result;
  }


  ShellEquations::Unbalance
  ShellEquations::start_from_prestress(State &state, const Loads &loads) const
  {
    Assert(loads.bodies.empty(), ExcInternalError());
    // from here on the shell is undeformed, and the loads to be balanced are
    // those on this shape
    internal.take_as_prestress(state);
    LA::Vector given = nodal_forces(state, loads)[ForceTerm::Source::loads];
    internal.balance(given, state);

    LA::Vector unbalanced = internal.unbalanced_forces(state);
    Unbalance  result;
    result.with_supports = unbalanced.l2_norm();
    mesh.condense(unbalanced);
    mesh.condense(given);
    result.forces = unbalanced.l2_norm();
    result.loads  = given.l2_norm();
    return result;
  }


  NodalForces
  ShellEquations::nodal_forces(const State &state,
                               const Loads &loads_at_end) const
  {
    const Loads               loads = acting_loads(state, loads_at_end);
    NodalForces               result(mesh);
    std::vector<LA::Vector *> of_terms;
    for (const ForceTerm *term : terms)
      of_terms.push_back(
        term->other_body().empty()
          ? &result[term->source()]
          : &result.of_bodies.emplace(term->other_body(), mesh.owned_vector())
               .first->second);
    // dead forces are linear in the loads, which stand for rates here
    for (const ForceTerm *term : terms)
      term->add_dead_forces({loads.pressure, loads.factors, 0},
                            result[term->source()]);
    internal.add_constant_forces(state, result[ForceTerm::Source::shell]);
    for (unsigned int t = 0; t < terms.size(); ++t)
      terms[t]->add_coupled_forces(state, loads, *of_terms[t]);

    ForceTerm::CellForces forces;
    forces.with_tangent = state.linearization_point != nullptr;
    for (const Element &element : elements)
      for (unsigned int t = 0; t < terms.size(); ++t)
        {
          forces.clear();
          add_forces(t, t + 1, element, state, loads, forces);
          const MixedElement::NodalVector force = forces.force + forces.load;
          if (force.norm_square() > 0)
            mesh.add_nodal_forces(*element.cell, force, *of_terms[t]);
        }
    result.compress();
    return result;
  }


  void
  ShellEquations::update_constraints(const State &state, const Loads &loads)
  {
    double violation = 0;
    for (const PrescribedDisplacement &p : mesh.prescribed)
      {
        // linear systems are those of increments, so that the first solution
        // attains the prescribed values
        double missing = value_of(p, loads) - state.displacement(p.dof);
        for (const auto &entry : *constraints.get_constraint_entries(p.dof))
          missing += entry.second * state.displacement(entry.first);
        constraints.set_inhomogeneity(p.dof, missing);
        violation = std::max(violation, std::abs(missing));
      }
    largest_violation = Utilities::MPI::max(violation, mesh.communicator);
  }


  double
  ShellEquations::relative_residual() const
  {
    const double norm = rhs.l2_norm();
    if (norm == 0)
      return 0;
    // without any force, only prescribed displacements contribute
    return force_scale == 0 ? 1. : norm / force_scale;
  }


  double
  ShellEquations::relative_roundoff(const State &state) const
  {
    if (force_scale == 0)
      return 0;
    // section 7 of doc/theory.md: forces that cancel in the residual leave
    // round-off of the order of |K||V|
    const Epetra_CrsMatrix &epetra = tangent().trilinos_matrix();
    const Epetra_Vector     V      = at_columns(tangent(), state.displacement);
    double                  square = 0;
    for (int row = 0; row < epetra.NumMyRows(); ++row)
      {
        if (mesh.constraints.is_constrained(epetra.GRID(row)))
          continue;
        const double force = absolute_product(tangent(), row, V);
        square += force * force;
      }
    return std::numeric_limits<double>::epsilon() *
           std::sqrt(Utilities::MPI::sum(square, mesh.communicator)) /
           force_scale;
  }


  void
  ShellEquations::update(State                &state,
                         const LA::Vector     &increment,
                         const NewtonIteration iteration) const
  {
    const bool predicts =
      iteration == NewtonIteration::mixed && !state.linearization_point;
    // before the displacements change, since the prediction is linear about the
    // old ones
    if (predicts)
      {
        LA::Vector ghosted_increment = mesh.ghosted_vector();
        ghosted_increment            = increment;
        internal.predict_resultants(state, ghosted_increment);
      }

    LA::Vector displacement = mesh.owned_vector();
    displacement            = state.displacement;
    displacement += increment;
    state.displacement = displacement;

    if (!predicts)
      internal.settle_resultants(state);
  }
} // namespace Biface
