// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/friction_by_slip_velocity.h>
#include <biface/model/contact/friction_with_history.h>

namespace Biface
{
  using namespace dealii;

  ContactTraction
  contact_traction(const ShellMesh   &mesh,
                   const State       &state,
                   const Loads       &loads,
                   const unsigned int node)
  {
    ContactTraction result;
    if (!loads.foundation || !state.active[node])
      return result;
    const Tensor<1, 3> &lambda = state.multipliers[node];
    const Tensor<1, 3>  normal =
      loads.foundation
        ->evaluate(mesh.deformed_position(
          state.displacement, mesh.nodes[node], Resultants::outer))
        .normal;
    const auto tangents = loads.foundation->tangents(normal);
    for (unsigned int i = 0; i < 2; ++i)
      result.friction += lambda[1 + i] * tangents[i];
    result.total = lambda[0] * normal + result.friction;
    return result;
  }


  void
  ContactInteraction::Parameters::add_parameters(ParameterHandler &prm)
  {
    foundation.add_parameters(prm);
    condition.add_parameters(prm);
    friction.add_parameters(prm);
  }


  void
  ContactInteraction::Parameters::check() const
  {
    condition.check();
    friction.check();
    foundation.check();
  }


  ContactInteraction::ContactInteraction(const ShellMesh  &mesh,
                                         const Parameters &parameters)
    : mesh(mesh)
    , condition(parameters.condition, mesh.wall_stiffness())
    , rolling(mesh)
    , foundation_at_rest(parameters.foundation)
    , friction_parameters(parameters.friction)
  {}


  std::shared_ptr<const TangentialLaw>
  ContactInteraction::law(const std::string &entry,
                          const std::string &coefficient,
                          const bool         glued,
                          const bool         rolls) const
  {
    const FrictionLaw law =
      friction_parameters.of_stage(entry, coefficient, mesh.wall_stiffness());
    if (law.is_zero() && !glued)
      return std::make_shared<const TangentialLaw>();
    if (rolls)
      return std::make_shared<const FrictionBySlipVelocity>(
        law, condition, rolling);
    return std::make_shared<const FrictionWithHistory>(law, condition, glued);
  }


  double
  ContactInteraction::touching_travel(const State &state) const
  {
    const RigidFoundation at_rest = foundation(0);
    const double          travel  = minimum_travel(state, at_rest);
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
    if (Utilities::MPI::logical_or(!fits, mesh.communicator))
      throw InputError("the shell does not fit into the hollow foundation of "
                       "the section 'Contact'.");
    return travel;
  }


  Point<3>
  ContactInteraction::touched_point(const State &state,
                                    const double touching_travel) const
  {
    // nodes that would touch together but for round-off
    const double tolerance = 1e-6 * mesh.thickness();

    const RigidFoundation at_rest = foundation(0);
    std::vector<double>   sums(4);
    for (const Node &node : mesh.nodes)
      {
        if (!node.outer_face_free || !node.locally_owned)
          continue;
        const Point<3> x =
          mesh.deformed_position(state.displacement, node, Resultants::outer);
        if (at_rest.travel_to(x) > touching_travel + tolerance)
          continue;
        for (unsigned int i = 0; i < 3; ++i)
          sums[i] += x[i];
        sums[3] += 1;
      }
    Utilities::MPI::sum(sums, mesh.communicator, sums);
    return Point<3>(sums[0], sums[1], sums[2]) / sums[3];
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
  ContactInteraction::remaining_travel(const State &state,
                                       const Loads &loads) const
  {
    return minimum_travel(state, *loads.foundation);
  }


  double
  ContactInteraction::minimum_travel(const State           &state,
                                     const RigidFoundation &foundation) const
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (const Node &node : mesh.nodes)
      if (node.outer_face_free)
        minimum = std::min(minimum,
                           foundation.travel_to(mesh.deformed_position(
                             state.displacement, node, Resultants::outer)));
    return Utilities::MPI::min(minimum, mesh.communicator);
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
        const Node        &node   = mesh.nodes[n];
        const Tensor<1, 3> last   = state.multipliers[n];
        bool               active = false;
        NodeInContact      at{};
        if (loads.foundation && node.outer_face_free)
          {
            at = contact_at(state, loads, n);
            active =
              (!held.empty() && held[n]) ||
              condition.should_be_active(last[0], at.foundation.clearance);
          }
        if (active != static_cast<bool>(state.active[n]))
          {
            state.active[n] = active;
            if (node.locally_owned)
              ++n_changes;
          }
        state.multipliers[n] = 0;
        if (!active)
          continue;
        state.multipliers[n][0] = last[0];
        if (!law_of(loads).acts_on(state, n))
          continue;
        if (law_of(loads).decide(state, loads, at, last) && node.locally_owned)
          ++n_changes;
        set_tangential_multipliers(state, loads, at);
      }
    return Utilities::MPI::sum(n_changes, mesh.communicator);
  }


  std::vector<ContactInteraction::Linearization>
  ContactInteraction::linearize(const State &state, const Loads &loads) const
  {
    std::vector<Linearization> result(mesh.nodes.size());
    if (loads.foundation)
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (state.active[n])
          {
            const NodeInContact at = contact_at(state, loads, n);
            result[n]              = {loads.foundation->at_rest(at.x),
                                      at.foundation.clearance,
                                      at.foundation.normal};
          }
    return result;
  }


  void
  ContactInteraction::predict_multipliers(
    State                            &state,
    const Loads                      &loads,
    const std::vector<Linearization> &before) const
  {
    AssertDimension(before.size(), mesh.nodes.size());
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      if (loads.foundation && state.active[n])
        {
          const Tensor<1, 3> motion =
            mesh.deformed_position(
              state.displacement, mesh.nodes[n], Resultants::outer) -
            loads.foundation->present(before[n].at_rest);
          state.multipliers[n][0] = condition.multiplier(
            before[n].clearance - before[n].normal * motion);
        }
      else
        state.multipliers[n] = 0;
  }


  unsigned int
  ContactInteraction::settle(State &state, const Loads &loads) const
  {
    if (loads.foundation)
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].outer_face_free)
          state.multipliers[n][0] = std::min(
            0., condition.multiplier(clearance(state, loads, mesh.nodes[n])));
    return update_active_set(state, loads);
  }


  void
  ContactInteraction::compute_multipliers(
    State                            &state,
    const Loads                      &loads,
    const std::vector<Linearization> &before,
    const LA::Vector                 &increment,
    const double                      travel) const
  {
    AssertDimension(before.size(), mesh.nodes.size());
    const Tensor<1, 3> of_foundation =
      (loads.foundation ? -travel * loads.foundation->direction()
                        : Tensor<1, 3>());
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        state.multipliers[n] = 0;
        if (!state.active[n])
          continue;
        const Node        &node   = mesh.nodes[n];
        const Tensor<1, 3> motion = node.surface.from_frame(
          mesh.displacement(increment, node, Resultants::outer));
        state.multipliers[n][0] = condition.multiplier(
          before[n].clearance - before[n].normal * (motion - of_foundation));
        if (law_of(loads).acts_on(state, n))
          set_tangential_multipliers(state, loads, contact_at(state, loads, n));
      }
  }


  void
  ContactInteraction::set_tangential_multipliers(State               &state,
                                                 const Loads         &loads,
                                                 const NodeInContact &at) const
  {
    const auto tangents = loads.foundation->tangents(at.foundation.normal);
    const Tensor<1, 3> traction = law_of(loads).traction(state, loads, at);
    for (unsigned int i = 0; i < 2; ++i)
      state.multipliers[at.node][1 + i] = tangents[i] * traction;
  }


  void
  ContactInteraction::let_stick(State &state) const
  {
    for (Grip &grip : state.grips)
      if (grip == Grip::slip)
        grip = Grip::stick;
  }


  void
  ContactInteraction::commit_step(State &state, const Loads &loads) const
  {
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      if (state.active[n])
        law_of(loads).commit_step(state, loads, contact_at(state, loads, n));
      else
        forget_stick_point(state, n);
  }


  bool
  ContactInteraction::release_glue(State &state, const ActiveSet &nodes) const
  {
    AssertDimension(nodes.size(), state.grips.size());
    bool any = false;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      if (nodes[n] && state.grips[n] == Grip::glued)
        {
          state.grips[n] = Grip::none;
          any            = true;
        }
    return Utilities::MPI::logical_or(any, mesh.communicator);
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


  unsigned int
  ContactInteraction::count_slipping(const State &state,
                                     const Loads &loads) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
      if (mesh.nodes[i].locally_owned && slips(state, loads, i))
        ++n;
    return Utilities::MPI::sum(n, mesh.communicator);
  }


  NodeInContact
  ContactInteraction::contact_at(const State       &state,
                                 const Loads       &loads,
                                 const unsigned int node) const
  {
    const Point<3> x = mesh.deformed_position(
      state.displacement, mesh.nodes[node], Resultants::outer);
    return {node, x, loads.foundation->evaluate(x)};
  }


  LinearizedTraction
  ContactInteraction::traction(const State       &state,
                               const Loads       &loads,
                               const unsigned int node) const
  {
    const NodeInContact at      = contact_at(state, loads, node);
    const Tensor<1, 3> &n       = at.foundation.normal;
    const double        epsilon = condition.multiplier_stiffness();
    LinearizedTraction  result;
    result.value = condition.multiplier(at.foundation.clearance) * n;
    result.stiffness =
      epsilon * outer_product(n, n) -
      state.multipliers[node][0] * Tensor<2, 3>(at.foundation.normal_gradient);
    law_of(loads).linearize(state, loads, at, result);
    return result;
  }


  double
  ContactInteraction::friction_work(const State &before,
                                    const State &after,
                                    const Loads &loads) const
  {
    double work = 0;
    if (has_friction(loads))
      for (const Cell &cell : mesh.cells)
        for (const unsigned int n : cell.nodes)
          if (after.active[n])
            // each column of both masses adds up to a quarter
            work -= cell.geometry.weight / 4 *
                    (contact_traction(mesh, after, loads, n).friction *
                     law_of(loads).slip_in_step(before, after, loads, n));
    return Utilities::MPI::sum(work, mesh.communicator);
  }


  namespace
  {
    /** The mean of a function of the nodal pressures, weighted by the forces
     * that they carry; zero if there are none. */
    template <typename Function>
    double
    mean_by_force(const ShellMesh &mesh,
                  const State     &state,
                  const Function  &function)
    {
      double force = 0, integral = 0;
      for (const Cell &cell : mesh.cells)
        for (const unsigned int n : cell.nodes)
          if (state.active[n])
            {
              const double pressure = state.contact_pressure(n);
              const double part     = cell.geometry.weight / 4 * pressure;
              force += part;
              integral += part * function(pressure);
            }
      force    = Utilities::MPI::sum(force, mesh.communicator);
      integral = Utilities::MPI::sum(integral, mesh.communicator);
      return force > 0 ? integral / force : 0.;
    }
  } // namespace


  ContactSummary
  ContactInteraction::summarize(const State &state, const Loads &loads) const
  {
    double force = 0, area = 0, slipping_area = 0, max_pressure = 0;
    if (loads.foundation)
      {
        const Tensor<1, 3> d = loads.foundation->direction();
        for (const Cell &cell : mesh.cells)
          for (const unsigned int n : cell.nodes)
            if (state.active[n])
              {
                // each column of both masses adds up to a quarter
                area += cell.geometry.weight / 4;
                if (slips(state, loads, n))
                  slipping_area += cell.geometry.weight / 4;
                force -= cell.geometry.weight / 4 *
                         (contact_traction(mesh, state, loads, n).total * d);
              }
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          if (mesh.nodes[n].locally_owned)
            max_pressure = std::max(max_pressure, state.contact_pressure(n));
      }

    const MPI_Comm communicator = mesh.communicator;
    ContactSummary summary;
    summary.force         = Utilities::MPI::sum(force, communicator);
    summary.area          = Utilities::MPI::sum(area, communicator);
    summary.slipping_area = Utilities::MPI::sum(slipping_area, communicator);
    summary.n_nodes       = count_active(state);
    summary.n_slipping    = count_slipping(state, loads);
    summary.max_pressure  = Utilities::MPI::max(max_pressure, communicator);
    if (summary.n_nodes > 0)
      {
        const double mean =
          mean_by_force(mesh, state, [](const double p) { return p; });
        const double square = mean_by_force(
          mesh, state, [&](const double p) { return (p - mean) * (p - mean); });
        summary.weighted_pressure = mean;
        if (mean > 0)
          summary.pressure_variation = std::sqrt(std::max(0., square)) / mean;
      }
    return summary;
  }
} // namespace Biface
