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

  ShellEquations::ShellEquations(const ShellMesh         &mesh,
                                 const ContactConditions &contact,
                                 const DeadLoads         &dead_loads,
                                 const PressureLoad      &pressure)
    : mesh(mesh)
    , pressure_kind(pressure.kind)
    , pressure_face(pressure.face)
    , pressure_distribution(pressure.values(mesh))
    , contact(contact)
    , constraints(mesh.constraints)
    , dead_load(dead_loads.assemble(mesh, pressure.area))
    , unit_load(dead_load)
    , unit_pressure(pressure.assemble_dead(mesh))
    , rhs(mesh.owned_vector())
    , adder(mesh, constraints, matrix)
  {
    for (const Strip &strip : mesh.strips)
      stiffness.emplace_back(strip.laminate.stiffness());
    initial_strains.resize(mesh.cells.size());
    for (const VertexMoment &moment :
         parse_edge_moments(dead_loads.edge_moments, true, mesh))
      moments[moment.cell].push_back(moment);
    symmetric_stiffness = mesh.strips[0].laminate.is_symmetric();
    for (const Cell &cell : mesh.cells)
      initial_resultants.push_back(
        Modes::constant(mesh.strips[cell.strip].laminate.initial_resultants()));
  }


  void
  ShellEquations::cell_equations(const State       &state,
                                 const Loads       &loads,
                                 const unsigned int c,
                                 CellEquations     &equations) const
  {
    const Cell  &cell = mesh.cells[c];
    const State &base = linearization_point ? *linearization_point : state;
    const auto   V    = mesh.cell_values(base.displacement, cell);
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
        const auto dV = mesh.cell_values(state.displacement, cell) - V;
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
    const Cell &cell = mesh.cells[c];
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
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        cell_equations(state, loads, c, equations);
        force_square += equations.force_square;
        adder.add(c, equations.tangent, equations.residual, matrix, rhs);
        if (pressure_kind == PressureKind::follower)
          mesh.add_nodal_forces(
            mesh.cells[c], equations.unit_pressure, unit_pressure);
        if (moments.count(c) > 0)
          mesh.add_nodal_forces(mesh.cells[c], equations.moments, unit_load);
      }
    matrix.compress(VectorOperation::add);
    rhs.compress(VectorOperation::add);
    unit_pressure.compress(VectorOperation::add);
    unit_load.compress(VectorOperation::add);

    const LA::Vector load = load_direction(loads);
    rhs += load;
    force_scale = std::sqrt(
      Utilities::MPI::sum(force_square, mesh.communicator) + load.norm_sqr());
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
    for (const PrescribedDisplacement &p : mesh.prescribed)
      {
        double missing = loads.factor * p.value - state.displacement(p.dof);
        if (p.other != numbers::invalid_dof_index)
          missing += p.factor * state.displacement(p.other);
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
    // without any force, what is left comes from prescribed displacements
    return force_scale == 0 ? 1. : norm / force_scale;
  }


  double
  ShellEquations::relative_roundoff(const State &state) const
  {
    if (force_scale == 0)
      return 0;
    double square = 0;
    for (const auto dof : mesh.locally_owned)
      if (!mesh.constraints.is_constrained(dof))
        {
          const double force =
            matrix.diag_element(dof) * state.displacement(dof);
          square += force * force;
        }
    return std::numeric_limits<double>::epsilon() *
           std::sqrt(Utilities::MPI::sum(square, mesh.communicator)) /
           force_scale;
  }


  bool
  ShellEquations::is_symmetric() const
  {
    return symmetric_stiffness && contact.is_symmetric() &&
           pressure_kind == PressureKind::dead;
  }
} // namespace Biface
