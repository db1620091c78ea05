// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/element/follower_pressure.h>
#include <biface/model/shell_equations.h>

namespace Biface
{
  using namespace dealii;

  ShellEquations::ShellEquations(const Discretization    &discretization,
                                 const ContactConditions &contact,
                                 const DeadLoads         &dead_loads,
                                 const PressureLoad      &pressure)
    : discretization(discretization)
    , pressure_kind(pressure.kind)
    , pressure_face(pressure.face)
    , pressure_distribution(pressure.values(discretization))
    , contact(contact)
    , constraints(discretization.constraints)
    , dead_load(dead_loads.assemble(discretization, pressure.area))
    , unit_load(dead_load)
    , unit_pressure(pressure.assemble_dead(discretization))
    , rhs(discretization.owned_vector())
    , adder(discretization, constraints, matrix)
  {
    for (const Strip &strip : discretization.strips)
      stiffness.emplace_back(strip.laminate.stiffness());
    initial_strains.resize(discretization.cells.size());
    for (const VertexMoment &moment :
         parse_edge_moments(dead_loads.edge_moments, true, discretization))
      moments[moment.cell].push_back(moment);
    symmetric_stiffness = discretization.strips[0].laminate.is_symmetric();
    for (const Cell &cell : discretization.cells)
      initial_resultants.push_back(Modes::constant(
        discretization.strips[cell.strip].laminate.initial_resultants()));
  }


  State
  ShellEquations::initial_state() const
  {
    State state;
    state.displacement = discretization.ghosted_vector();
    state.resultants.resize(discretization.cells.size());
    state.active.resize(discretization.nodes.size(), 0);
    return state;
  }


  void
  ShellEquations::set_theory(const StrainTheory theory, const State &state)
  {
    if (theory == StrainTheory::linear)
      linearization_point = state;
    else
      linearization_point.reset();
  }


  void
  ShellEquations::take_as_prestress(State &state)
  {
    for (unsigned int c = 0; c < discretization.cells.size(); ++c)
      {
        initial_resultants[c] += state.resultants[c];
        initial_strains[c] = total_strains(state, c);
      }
    state = initial_state();
  }


  void
  ShellEquations::cell_equations(const State       &state,
                                 const Loads       &loads,
                                 const unsigned int c,
                                 CellEquations     &equations) const
  {
    const Cell  &cell = discretization.cells[c];
    const State &base = linearization_point ? *linearization_point : state;
    const auto   V    = discretization.cell_values(base.displacement, cell);
    const MixedElement element(cell.geometry, V);

    // the residual is that of the displacements, the tangent that of the
    // current resultants: see NewtonIteration::mixed
    const Modes::Vector H = stiffness_of(cell).resultants(element.strain());
    element.tangent(stiffness_of(cell),
                    base.resultants[c] + initial_resultants[c],
                    equations.tangent);
    MixedElement::NodalVector force =
      element.internal_force(H, initial_resultants[c]);

    add_follower_loads(loads, c, V, equations);

    if (linearization_point)
      {
        const auto dV =
          discretization.cell_values(state.displacement, cell) - V;
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
            force[i] += equations.tangent[i][j] * dV[j];
      }

    equations.residual     = -force;
    equations.force_square = force.norm_square();

    if (loads.foundation)
      add_contact(state, loads, cell, equations);
  }


  void
  ShellEquations::add_follower_loads(const Loads                     &loads,
                                     const unsigned int               c,
                                     const MixedElement::NodalVector &V,
                                     CellEquations &equations) const
  {
    const Cell &cell = discretization.cells[c];
    if (pressure_kind == PressureKind::follower)
      {
        std::array<double, 4> distribution;
        for (unsigned int v = 0; v < 4; ++v)
          distribution[v] = pressure_distribution[cell.nodes[v]];
        const FollowerPressure pressure(
          cell.geometry, V, pressure_face, distribution);
        equations.unit_pressure = pressure.force();
        pressure.add_derivative(-loads.pressure, equations.tangent);
      }

    const auto found = moments.find(c);
    if (found == moments.end())
      return;
    equations.moments = 0;
    for (const VertexMoment &moment : found->second)
      {
        const auto dof = [&](const unsigned int i, const unsigned int face) {
          return MixedElement::dof(moment.vertex, i, face);
        };
        Tensor<1, 3> director;
        for (unsigned int i = 0; i < 3; ++i)
          director[i] =
            V[dof(i, Resultants::outer)] - V[dof(i, Resultants::inner)];
        director[2] += cell.geometry.vertices[moment.vertex].thickness;

        const FollowerCouple couple(moment.moment, moment.axis, director);
        for (unsigned int i = 0; i < 3; ++i)
          for (const auto face : {Resultants::inner, Resultants::outer})
            {
              const double sign = (face == Resultants::outer ? 1 : -1);
              equations.moments[dof(i, face)] += sign * couple.force[i];
              for (unsigned int j = 0; j < 3; ++j)
                {
                  const double k =
                    sign * loads.factor * couple.derivative[i][j];
                  equations.tangent[dof(i, face)][dof(j, Resultants::outer)] -=
                    k;
                  equations.tangent[dof(i, face)][dof(j, Resultants::inner)] +=
                    k;
                }
            }
      }
  }


  void
  ShellEquations::add_contact(const State   &state,
                              const Loads   &loads,
                              const Cell    &cell,
                              CellEquations &equations) const
  {
    bool any_active = false;
    for (const unsigned int node : cell.nodes)
      any_active = any_active || state.active[node];
    if (!any_active)
      return;

    const auto M = multiplier_mass(contact.mass(), cell.geometry.weight);

    // the foundation's normal in the frames of the nodes
    std::array<Tensor<1, 3>, 4> m;
    for (unsigned int r = 0; r < 4; ++r)
      m[r] = discretization.nodes[cell.nodes[r]].surface.to_frame(
        loads.foundation->normal());

    for (unsigned int s = 0; s < 4; ++s)
      {
        const unsigned int node = cell.nodes[s];
        if (!state.active[node])
          continue;
        const double lambda = contact.multiplier(
          clearance(state, loads, discretization.nodes[node]));
        for (unsigned int r = 0; r < 4; ++r)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const unsigned int row =
                MixedElement::dof(r, i, Resultants::outer);
              const double force = M[r][s] * lambda * m[r][i];
              equations.residual[row] += force;
              equations.force_square += force * force;
              for (unsigned int j = 0; j < 3; ++j)
                equations
                  .tangent[row][MixedElement::dof(s, j, Resultants::outer)] +=
                  M[r][s] * contact.multiplier_stiffness() * m[r][i] * m[s][j];
            }
      }
  }


  void
  ShellEquations::assemble(const State &state, const Loads &loads)
  {
    update_constraints(state, loads);
    matrix = 0;
    rhs    = 0;

    double        force_square = 0;
    CellEquations equations;
    unit_load = dead_load;
    if (pressure_kind == PressureKind::follower)
      unit_pressure = 0;
    for (unsigned int c = 0; c < discretization.cells.size(); ++c)
      {
        cell_equations(state, loads, c, equations);
        force_square += equations.force_square;
        adder.add(c, equations.tangent, equations.residual, matrix, rhs);
        if (pressure_kind == PressureKind::follower)
          discretization.add_nodal_forces(
            discretization.cells[c], equations.unit_pressure, unit_pressure);
        if (moments.count(c) > 0)
          discretization.add_nodal_forces(
            discretization.cells[c], equations.moments, unit_load);
      }
    matrix.compress(VectorOperation::add);
    rhs.compress(VectorOperation::add);
    unit_pressure.compress(VectorOperation::add);
    unit_load.compress(VectorOperation::add);

    const LA::Vector load = load_direction(loads);
    rhs += load;
    force_scale =
      std::sqrt(Utilities::MPI::sum(force_square, discretization.communicator) +
                load.norm_sqr());
  }


  LA::Vector
  ShellEquations::load_direction(const Loads &rate) const
  {
    LA::Vector direction(unit_pressure);
    direction.sadd(rate.pressure, rate.factor, unit_load);
    return direction;
  }


  void
  ShellEquations::update_constraints(const State &state, const Loads &loads)
  {
    double violation = 0;
    for (const PrescribedDisplacement &p : discretization.prescribed)
      {
        double missing = loads.factor * p.value - state.displacement(p.dof);
        if (p.other != numbers::invalid_dof_index)
          missing += p.factor * state.displacement(p.other);
        constraints.set_inhomogeneity(p.dof, missing);
        violation = std::max(violation, std::abs(missing));
      }
    largest_violation =
      Utilities::MPI::max(violation, discretization.communicator);
  }


  double
  ShellEquations::relative_residual() const
  {
    const double norm = rhs.l2_norm();
    if (norm == 0)
      return 0;
    // without any force, what is left comes from prescribed displacements
    return force_scale == 0 ? 1. : norm / force_scale;
  }


  double
  ShellEquations::relative_roundoff(const State &state) const
  {
    if (force_scale == 0)
      return 0;
    double square = 0;
    for (const auto dof : discretization.locally_owned)
      if (!discretization.constraints.is_constrained(dof))
        {
          const double force =
            matrix.diag_element(dof) * state.displacement(dof);
          square += force * force;
        }
    return std::numeric_limits<double>::epsilon() *
           std::sqrt(Utilities::MPI::sum(square, discretization.communicator)) /
           force_scale;
  }


  bool
  ShellEquations::is_symmetric() const
  {
    return symmetric_stiffness && contact.is_symmetric() &&
           pressure_kind == PressureKind::dead;
  }


  void
  ShellEquations::update(State                &state,
                         const LA::Vector     &increment,
                         const NewtonIteration iteration) const
  {
    if (iteration == NewtonIteration::mixed && !linearization_point)
      {
        LA::Vector ghosted_increment = discretization.ghosted_vector();
        ghosted_increment            = increment;
        for (unsigned int c = 0; c < discretization.cells.size(); ++c)
          {
            const Cell        &cell = discretization.cells[c];
            const MixedElement element(
              cell.geometry,
              discretization.cell_values(state.displacement, cell));
            state.resultants[c] = stiffness_of(cell).resultants(
              element.strain() +
              element.strain_variation(
                discretization.cell_values(ghosted_increment, cell)));
          }
      }

    LA::Vector displacement = discretization.owned_vector();
    displacement            = state.displacement;
    displacement += increment;
    state.displacement = displacement;

    if (iteration == NewtonIteration::substituted || linearization_point)
      settle_resultants(state);
  }


  Modes::Vector
  ShellEquations::strains(const State &state, const Cell &cell) const
  {
    const auto V = discretization.cell_values(state.displacement, cell);
    if (!linearization_point)
      return MixedElement(cell.geometry, V).strain();

    const auto V_0 =
      discretization.cell_values(linearization_point->displacement, cell);
    const MixedElement element(cell.geometry, V_0);
    return element.strain() + element.strain_variation(V - V_0);
  }


  Modes::Vector
  ShellEquations::total_strains(const State &state, const unsigned int c) const
  {
    return strains(state, discretization.cells[c]) + initial_strains[c];
  }


  void
  ShellEquations::settle_resultants(State &state) const
  {
    for (unsigned int c = 0; c < discretization.cells.size(); ++c)
      {
        const Cell &cell = discretization.cells[c];
        state.resultants[c] =
          stiffness_of(cell).resultants(strains(state, cell));
      }
  }


  unsigned int
  ShellEquations::update_active_set(State &state, const Loads &loads) const
  {
    unsigned int n_changes = 0;
    for (unsigned int n = 0; n < discretization.nodes.size(); ++n)
      {
        const Node &node = discretization.nodes[n];
        const bool  active =
          loads.foundation && node.outer_face_free &&
          ContactConditions::should_be_active(clearance(state, loads, node));
        if (active != static_cast<bool>(state.active[n]))
          {
            state.active[n] = active;
            if (node.locally_owned)
              ++n_changes;
          }
      }
    return Utilities::MPI::sum(n_changes, discretization.communicator);
  }


  unsigned int
  ShellEquations::count_active(const State &state) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < state.active.size(); ++i)
      if (state.active[i] && discretization.nodes[i].locally_owned)
        ++n;
    return Utilities::MPI::sum(n, discretization.communicator);
  }


  double
  ShellEquations::clearance(const State &state,
                            const Loads &loads,
                            const Node  &node) const
  {
    return loads.foundation->clearance(discretization.deformed_position(
      state.displacement, node, Resultants::outer));
  }


  LA::Vector
  ShellEquations::travel_direction(const State &state, const Loads &loads) const
  {
    LA::Vector direction = discretization.owned_vector();
    for (const Cell &cell : discretization.cells)
      {
        const auto M = multiplier_mass(contact.mass(), cell.geometry.weight);
        MixedElement::NodalVector force;
        for (unsigned int r = 0; r < 4; ++r)
          {
            const Tensor<1, 3> m =
              discretization.nodes[cell.nodes[r]].surface.to_frame(
                loads.foundation->normal());
            for (unsigned int s = 0; s < 4; ++s)
              if (state.active[cell.nodes[s]])
                for (unsigned int i = 0; i < 3; ++i)
                  force[MixedElement::dof(r, i, Resultants::outer)] -=
                    M[r][s] * contact.multiplier_stiffness() * m[i];
          }
        discretization.add_nodal_forces(cell, force, direction);
      }
    direction.compress(VectorOperation::add);
    return direction;
  }


  ShellEquations::ContactForce
  ShellEquations::contact_force(const State &state, const Loads &loads) const
  {
    double     value = 0, per_travel = 0;
    LA::Vector gradient = discretization.owned_vector();
    for (const Cell &cell : discretization.cells)
      {
        MixedElement::NodalVector per_displacement;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const unsigned int node = cell.nodes[v];
            if (!state.active[node])
              continue;
            // the columns of both masses add up to a quarter each
            const double area = cell.geometry.weight / 4;
            value += area * pressure(state, loads, node);
            per_travel += area * contact.multiplier_stiffness();
            const Tensor<1, 3> m = discretization.nodes[node].surface.to_frame(
              loads.foundation->normal());
            for (unsigned int i = 0; i < 3; ++i)
              per_displacement[MixedElement::dof(v, i, Resultants::outer)] +=
                area * contact.multiplier_stiffness() * m[i];
          }
        discretization.add_nodal_forces(cell, per_displacement, gradient);
      }
    gradient.compress(VectorOperation::add);
    const MPI_Comm communicator = discretization.communicator;
    return {Utilities::MPI::sum(value, communicator),
            gradient,
            Utilities::MPI::sum(per_travel, communicator)};
  }


  double
  ShellEquations::least_clearance(const State &state, const Loads &loads) const
  {
    double least = std::numeric_limits<double>::max();
    for (const Node &node : discretization.nodes)
      if (node.outer_face_free)
        least = std::min(least, clearance(state, loads, node));
    return Utilities::MPI::min(least, discretization.communicator);
  }


  double
  ShellEquations::pressure(const State       &state,
                           const Loads       &loads,
                           const unsigned int node) const
  {
    if (!state.active[node])
      return 0;
    return -contact.multiplier(
      clearance(state, loads, discretization.nodes[node]));
  }


  ContactSummary
  ShellEquations::summarize_contact(const State &state,
                                    const Loads &loads) const
  {
    double force = 0, area = 0, max_pressure = 0;
    if (loads.foundation)
      {
        force = contact_force(state, loads).value;
        for (const Cell &cell : discretization.cells)
          for (const unsigned int node : cell.nodes)
            if (state.active[node])
              area += cell.geometry.weight / 4;
        for (unsigned int n = 0; n < discretization.nodes.size(); ++n)
          if (discretization.nodes[n].locally_owned && state.active[n])
            max_pressure = std::max(max_pressure, pressure(state, loads, n));
      }

    const MPI_Comm communicator = discretization.communicator;
    ContactSummary summary;
    summary.force        = force;
    summary.area         = Utilities::MPI::sum(area, communicator);
    summary.n_nodes      = count_active(state);
    summary.max_pressure = Utilities::MPI::max(max_pressure, communicator);
    return summary;
  }


  RigidPlane
  ShellEquations::touching_plane(const State &state) const
  {
    const RigidPlane through_origin(contact.normal(), 0);
    double           height = -std::numeric_limits<double>::max();
    for (const Node &node : discretization.nodes)
      height = std::max(height,
                        through_origin.height(discretization.deformed_position(
                          state.displacement, node, Resultants::outer)));
    return through_origin.moved(
      -Utilities::MPI::max(height, discretization.communicator));
  }


  double
  ShellEquations::strain_energy(const State &state) const
  {
    double energy = 0;
    for (unsigned int c = 0; c < discretization.cells.size(); ++c)
      {
        const Cell        &cell = discretization.cells[c];
        const MixedElement element(
          cell.geometry, discretization.cell_values(state.displacement, cell));
        const Modes::Vector E = element.strain();
        energy +=
          cell.geometry.weight *
          (Modes::mean_product(stiffness_of(cell).resultants(E), E) / 2 +
           Modes::mean_product(initial_resultants[c],
                               element.nonlinear_strain()));
      }
    return Utilities::MPI::sum(energy, discretization.communicator);
  }
} // namespace Biface
