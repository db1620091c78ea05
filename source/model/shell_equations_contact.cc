// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/model/shell_equations.h>

namespace Biface
{
  using namespace dealii;

  ShellEquations::ContactTraction
  ShellEquations::contact_traction(const State &state,
                                   const Loads &loads,
                                   const Node  &node) const
  {
    const FoundationPoint at = loads.foundation->evaluate(
      mesh.deformed_position(state.displacement, node, Resultants::outer));
    const double lambda = contact.multiplier(at.clearance);
    return {lambda * at.normal,
            contact.multiplier_stiffness() *
                symmetrize(outer_product(at.normal, at.normal)) -
              lambda * at.normal_gradient};
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
    const auto frame =
      [&](const unsigned int v) -> const std::array<Tensor<1, 3>, 3> & {
      return mesh.nodes[cell.nodes[v]].surface.frame;
    };
    for (unsigned int s = 0; s < 4; ++s)
      {
        const unsigned int node = cell.nodes[s];
        if (!state.active[node])
          continue;
        const ContactTraction traction =
          contact_traction(state, loads, mesh.nodes[node]);
        std::array<Tensor<1, 3>, 3> columns;
        for (unsigned int j = 0; j < 3; ++j)
          columns[j] = traction.stiffness * frame(s)[j];

        for (unsigned int r = 0; r < 4; ++r)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const unsigned int row =
                MixedElement::dof(r, i, Resultants::outer);
              const double force = M[r][s] * (frame(r)[i] * traction.value);
              equations.residual[row] += force;
              equations.force_square += force * force;
              for (unsigned int j = 0; j < 3; ++j)
                equations
                  .tangent[row][MixedElement::dof(s, j, Resultants::outer)] +=
                  M[r][s] * (frame(r)[i] * columns[j]);
            }
      }
  }


  unsigned int
  ShellEquations::update_active_set(
    State                              &state,
    const Loads                        &loads,
    const ContactConditions::ActiveSet &held) const
  {
    Assert(held.empty() || held.size() == mesh.nodes.size(),
           ExcDimensionMismatch(held.size(), mesh.nodes.size()));
    unsigned int n_changes = 0;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Node &node = mesh.nodes[n];
        const bool  active =
          loads.foundation && node.outer_face_free &&
          ((!held.empty() && held[n]) ||
           ContactConditions::should_be_active(clearance(state, loads, node)));
        if (active != static_cast<bool>(state.active[n]))
          {
            state.active[n] = active;
            if (node.locally_owned)
              ++n_changes;
          }
      }
    return Utilities::MPI::sum(n_changes, mesh.communicator);
  }


  unsigned int
  ShellEquations::count_active(const State &state) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < state.active.size(); ++i)
      if (state.active[i] && mesh.nodes[i].locally_owned)
        ++n;
    return Utilities::MPI::sum(n, mesh.communicator);
  }


  double
  ShellEquations::clearance(const State &state,
                            const Loads &loads,
                            const Node  &node) const
  {
    return loads.foundation->clearance(
      mesh.deformed_position(state.displacement, node, Resultants::outer));
  }


  LA::Vector
  ShellEquations::travel_direction(const State &state, const Loads &loads) const
  {
    LA::Vector direction = mesh.owned_vector();
    for (const Cell &cell : mesh.cells)
      {
        const auto M = multiplier_mass(contact.mass(), cell.geometry.weight);
        MixedElement::NodalVector force;
        for (unsigned int s = 0; s < 4; ++s)
          {
            const unsigned int node = cell.nodes[s];
            if (!state.active[node])
              continue;
            // the foundation's travel is as good as the node's the other way
            const Tensor<1, 3> per_travel =
              -(contact_traction(state, loads, mesh.nodes[node]).stiffness *
                loads.foundation->direction());
            for (unsigned int r = 0; r < 4; ++r)
              {
                const Tensor<1, 3> m =
                  mesh.nodes[cell.nodes[r]].surface.to_frame(per_travel);
                for (unsigned int i = 0; i < 3; ++i)
                  force[MixedElement::dof(r, i, Resultants::outer)] +=
                    M[r][s] * m[i];
              }
          }
        mesh.add_nodal_forces(cell, force, direction);
      }
    direction.compress(VectorOperation::add);
    return direction;
  }


  ShellEquations::ContactForce
  ShellEquations::contact_force(const State &state, const Loads &loads) const
  {
    const Tensor<1, 3> d     = loads.foundation->direction();
    double             value = 0, per_travel = 0;
    LA::Vector         gradient = mesh.owned_vector();
    for (const Cell &cell : mesh.cells)
      {
        MixedElement::NodalVector per_displacement;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const unsigned int node = cell.nodes[v];
            if (!state.active[node])
              continue;
            const ContactTraction traction =
              contact_traction(state, loads, mesh.nodes[node]);
            const Tensor<1, 3> per_motion = traction.stiffness * d;
            // the columns of both masses add up to a quarter each
            const double area = cell.geometry.weight / 4;
            value -= area * (traction.value * d);
            per_travel += area * (per_motion * d);
            const Tensor<1, 3> m =
              mesh.nodes[node].surface.to_frame(per_motion);
            for (unsigned int i = 0; i < 3; ++i)
              per_displacement[MixedElement::dof(v, i, Resultants::outer)] +=
                area * m[i];
          }
        mesh.add_nodal_forces(cell, per_displacement, gradient);
      }
    gradient.compress(VectorOperation::add);
    const MPI_Comm communicator = mesh.communicator;
    return {Utilities::MPI::sum(value, communicator),
            gradient,
            Utilities::MPI::sum(per_travel, communicator)};
  }


  double
  ShellEquations::travel_to_touch(const State &state, const Loads &loads) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Node &node : mesh.nodes)
      if (node.outer_face_free)
        least = std::min(least,
                         loads.foundation->travel_to(mesh.deformed_position(
                           state.displacement, node, Resultants::outer)));
    return Utilities::MPI::min(least, mesh.communicator);
  }


  double
  ShellEquations::pressure(const State       &state,
                           const Loads       &loads,
                           const unsigned int node) const
  {
    if (!state.active[node])
      return 0;
    return -contact.multiplier(clearance(state, loads, mesh.nodes[node]));
  }


  ContactSummary
  ShellEquations::summarize_contact(const State &state,
                                    const Loads &loads) const
  {
    double force = 0, area = 0, max_pressure = 0;
    if (loads.foundation)
      {
        force = contact_force(state, loads).value;
        for (const Cell &cell : mesh.cells)
          for (const unsigned int node : cell.nodes)
            if (state.active[node])
              area += cell.geometry.weight / 4;
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          if (mesh.nodes[n].locally_owned && state.active[n])
            max_pressure = std::max(max_pressure, pressure(state, loads, n));
      }

    const MPI_Comm communicator = mesh.communicator;
    ContactSummary summary;
    summary.force        = force;
    summary.area         = Utilities::MPI::sum(area, communicator);
    summary.n_nodes      = count_active(state);
    summary.max_pressure = Utilities::MPI::max(max_pressure, communicator);
    return summary;
  }


  MovedFoundation
  ShellEquations::foundation(const double travel) const
  {
    return contact.foundation_at_rest().moved(travel);
  }


  double
  ShellEquations::touching_travel(const State &state) const
  {
    const MovedFoundation at_rest = foundation(0);

    double travel = std::numeric_limits<double>::infinity();
    for (const Node &node : mesh.nodes)
      travel = std::min(travel,
                        at_rest.travel_to(mesh.deformed_position(
                          state.displacement, node, Resultants::outer)));
    travel = Utilities::MPI::min(travel, mesh.communicator);
    if (travel == std::numeric_limits<double>::infinity())
      throw InputError("the foundation of the section 'Contact' passes by the "
                       "shell, but on its path it must meet a node of it.");

    // the shell may be too large for a hollow foundation
    const MovedFoundation touching = at_rest.moved(travel);
    bool                  fits     = std::isfinite(travel);
    for (const Node &node : mesh.nodes)
      fits = fits && touching.clearance(mesh.deformed_position(
                       state.displacement, node, Resultants::outer)) >
                       -1e-9 * mesh.size();
    if (Utilities::MPI::max(static_cast<unsigned int>(!fits),
                            mesh.communicator) > 0)
      throw InputError("the shell does not fit into the hollow foundation of "
                       "the section 'Contact', but it must.");
    return travel;
  }
} // namespace Biface
