// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/model/contact_interaction.h>

namespace Biface
{
  using namespace dealii;

  void
  ContactInteraction::Parameters::add_parameters(ParameterHandler &prm)
  {
    foundation.add_parameters(prm);
    condition.add_parameters(prm);
  }


  void
  ContactInteraction::Parameters::check() const
  {
    condition.check();
    foundation.check();
  }


  ContactInteraction::ContactInteraction(const ShellMesh  &mesh,
                                         const Parameters &parameters)
    : mesh(mesh)
    , condition(parameters.condition)
    , foundation_at_rest(parameters.foundation)
  {}


  double
  ContactInteraction::touching_travel(const State &state) const
  {
    const RigidFoundation at_rest = foundation(0);

    double travel = std::numeric_limits<double>::infinity();
    for (const Node &node : mesh.nodes)
      if (node.outer_face_free)
        travel = std::min(travel,
                          at_rest.travel_to(mesh.deformed_position(
                            state.displacement, node, Resultants::outer)));
    travel = Utilities::MPI::min(travel, mesh.communicator);
    if (travel == std::numeric_limits<double>::infinity())
      throw InputError("the foundation of the section 'Contact' misses the "
                       "shell; its path must meet a node.");

    // the shell may not fit into a hollow foundation
    const RigidFoundation touching = at_rest.moved(travel);
    bool                  fits     = std::isfinite(travel);
    for (const Node &node : mesh.nodes)
      if (node.outer_face_free)
        fits = fits && touching.clearance(mesh.deformed_position(
                         state.displacement, node, Resultants::outer)) >
                         -1e-9 * mesh.size();
    if (Utilities::MPI::max(static_cast<unsigned int>(!fits),
                            mesh.communicator) > 0)
      throw InputError("the shell does not fit into the hollow foundation of "
                       "the section 'Contact'.");
    return travel;
  }


  ActiveSet
  ContactInteraction::pierced_nodes(const State &state,
                                    const Loads &loads) const
  {
    const double small = 1e-3 * mesh.thickness();
    ActiveSet    pierced(mesh.nodes.size(), 0);
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      pierced[n] = (!mesh.nodes[n].outer_face_free &&
                    clearance(state, loads, mesh.nodes[n]) < -small);
    return pierced;
  }


  double
  ContactInteraction::travel_to_touch(const State &state,
                                      const Loads &loads) const
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
  ContactInteraction::clearance(const State &state,
                                const Loads &loads,
                                const Node  &node) const
  {
    return loads.foundation->clearance(
      mesh.deformed_position(state.displacement, node, Resultants::outer));
  }


  unsigned int
  ContactInteraction::update_active_set(State           &state,
                                        const Loads     &loads,
                                        const ActiveSet &held) const
  {
    Assert(held.empty() || held.size() == mesh.nodes.size(),
           ExcDimensionMismatch(held.size(), mesh.nodes.size()));
    unsigned int n_changes = 0;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        const Node &node      = mesh.nodes[n];
        bool        active    = false;
        double      clearance = 0;
        if (loads.foundation && node.outer_face_free)
          {
            clearance = this->clearance(state, loads, node);
            // the multiplier that was eliminated from the last linear system
            const double multiplier =
              (state.active[n] ? condition.multiplier(clearance) : 0.);
            active = (!held.empty() && held[n]) ||
                     condition.should_be_active(multiplier, clearance);
          }
        if (active != static_cast<bool>(state.active[n]))
          {
            state.active[n] = active;
            if (node.locally_owned)
              ++n_changes;
          }
        state.multipliers[n] = 0;
        if (active)
          state.multipliers[n][0] = condition.multiplier(clearance);
      }
    return Utilities::MPI::sum(n_changes, mesh.communicator);
  }


  unsigned int
  ContactInteraction::count_active(const State &state) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < state.active.size(); ++i)
      if (state.active[i] && mesh.nodes[i].locally_owned)
        ++n;
    return Utilities::MPI::sum(n, mesh.communicator);
  }


  ContactInteraction::Traction
  ContactInteraction::traction(const State &state,
                               const Loads &loads,
                               const Node  &node) const
  {
    const FoundationPoint at = loads.foundation->evaluate(
      mesh.deformed_position(state.displacement, node, Resultants::outer));
    const double lambda = condition.multiplier(at.clearance);
    return {lambda * at.normal,
            condition.multiplier_stiffness() *
                symmetrize(outer_product(at.normal, at.normal)) -
              lambda * at.normal_gradient};
  }


  ContactInteraction::Force
  ContactInteraction::force(const State &state, const Loads &loads) const
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
            const Traction traction =
              this->traction(state, loads, mesh.nodes[node]);
            const Tensor<1, 3> per_motion = traction.stiffness * d;
            // each column of both masses adds up to a quarter
            const double area = cell.geometry.weight / 4;
            value -= area * (traction.value * d);
            per_travel += area * (per_motion * d);
            const Tensor<1, 3> m =
              mesh.nodes[node].surface.to_frame(per_motion);
            MixedElement::add_force(
              area * m, v, cell.sign_of_outer_face(v), per_displacement);
          }
        mesh.add_nodal_forces(cell, per_displacement, gradient);
      }
    gradient.compress(VectorOperation::add);
    mesh.condense(gradient);
    const MPI_Comm communicator = mesh.communicator;
    return {Utilities::MPI::sum(value, communicator),
            gradient,
            Utilities::MPI::sum(per_travel, communicator)};
  }


  ContactSummary
  ContactInteraction::summarize(const State &state, const Loads &loads) const
  {
    double force = 0, area = 0, max_pressure = 0;
    if (loads.foundation)
      {
        const Tensor<1, 3> d = loads.foundation->direction();
        for (const Cell &cell : mesh.cells)
          for (const unsigned int n : cell.nodes)
            if (state.active[n])
              {
                const Tensor<1, 3> normal =
                  loads.foundation
                    ->evaluate(mesh.deformed_position(
                      state.displacement, mesh.nodes[n], Resultants::outer))
                    .normal;
                // each column of both masses adds up to a quarter
                area += cell.geometry.weight / 4;
                force -= cell.geometry.weight / 4 *
                         ((state.multipliers[n][0] * normal) * d);
              }
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          if (mesh.nodes[n].locally_owned)
            max_pressure = std::max(max_pressure, state.contact_pressure(n));
      }

    const MPI_Comm communicator = mesh.communicator;
    ContactSummary summary;
    summary.force        = Utilities::MPI::sum(force, communicator);
    summary.area         = Utilities::MPI::sum(area, communicator);
    summary.n_nodes      = count_active(state);
    summary.max_pressure = Utilities::MPI::max(max_pressure, communicator);
    return summary;
  }
} // namespace Biface
