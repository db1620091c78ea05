// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>

#include <biface/contact/body_parameters.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/contact/contact_summary.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::unique_ptr<const ContactPair>>
    make_pairs(const ShellMesh                      &mesh,
               const std::vector<ContactParameters> &parameters)
    {
      std::vector<std::unique_ptr<const ContactPair>> pairs;
      for (const ContactParameters &pair : parameters)
        pairs.push_back(
          std::make_unique<const ContactPair>(mesh, pair, pairs.size()));
      return pairs;
    }


    std::vector<std::unique_ptr<const ContactPair>>
    make_pairs(const ShellMesh                   &mesh,
               const ContactParameters           &ground,
               const std::vector<BodyParameters> &bodies)
    {
      auto pairs = make_pairs(mesh, {ground});
      for (const BodyParameters &body : bodies)
        pairs.push_back(std::make_unique<const ContactPair>(
          mesh, ground, body, pairs.size()));
      return pairs;
    }


    /** The sum of a number of each pair. */
    template <typename Function>
    unsigned int
    sum_of_pairs(const ContactInteraction &contact, const Function &number)
    {
      unsigned int sum = 0;
      for (const auto &pair : contact.pairs)
        sum += number(*pair);
      return sum;
    }
  } // namespace


  ContactInteraction::ContactInteraction(
    const ShellMesh &mesh, const std::vector<ContactParameters> &parameters)
    : mesh(mesh), pairs(make_pairs(mesh, parameters))
  {}


  ContactInteraction::ContactInteraction(
    const ShellMesh                   &mesh,
    const ContactParameters           &ground,
    const std::vector<BodyParameters> &bodies)
    : mesh(mesh), pairs(make_pairs(mesh, ground, bodies))
  {}


  ContactInteraction::ContactInteraction(const ShellMesh         &mesh,
                                         const ContactParameters &ground)
    : ContactInteraction(mesh, ground, {})
  {}


  ContactInteraction::~ContactInteraction() = default;


  std::vector<const ContactPair *>
  ContactInteraction::present(const Loads &loads) const
  {
    std::vector<const ContactPair *> result;
    for (const auto &pair : pairs)
      if (pair->body(loads))
        result.push_back(pair.get());
    return result;
  }


  State
  ContactInteraction::unloaded_state() const
  {
    return State(mesh, pairs.size(), ground().points.per_cell());
  }


  bool
  ContactInteraction::has_friction(const Loads &loads) const
  {
    return std::any_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
      return pair->has_friction(loads);
    });
  }


  ContactInteraction::Linearizations
  ContactInteraction::linearize(const State     &state,
                                const Loads     &loads,
                                const LoadRates &change) const
  {
    Linearizations result;
    for (const auto &pair : pairs)
      result.push_back(pair->linearize(state, loads, change));
    return result;
  }


  void
  ContactInteraction::predict_multipliers(State                &state,
                                          const Loads          &loads,
                                          const Linearizations &before) const
  {
    for (const auto &pair : pairs)
      pair->predict_multipliers(state, loads, before[pair->number]);
  }


  ActiveSet
  ContactInteraction::active_points(const State &state) const
  {
    ActiveSet result;
    for (const auto &pair : pairs)
      {
        const ActiveSet &active = pair->state_of(state).active;
        result.insert(result.end(), active.begin(), active.end());
      }
    return result;
  }


  void
  ContactInteraction::set_active_points(State           &state,
                                        const ActiveSet &active) const
  {
    for (const auto &pair : pairs)
      pair->state_of(state).active = part_of(active, *pair);
  }


  ActiveSet
  ContactInteraction::part_of(const ActiveSet   &of_pairs,
                              const ContactPair &pair) const
  {
    if (of_pairs.empty())
      return {};
    // all pairs have as many points
    const unsigned int n = pair.points.size();
    AssertDimension(of_pairs.size(), pairs.size() * n);
    const auto start = of_pairs.begin() + pair.number * n;
    return ActiveSet(start, start + n);
  }


  ActiveSet
  ContactInteraction::nodes_around(const ActiveSet &of_pairs) const
  {
    ActiveSet result(mesh.nodes.size(), 0);
    for (const auto &pair : pairs)
      {
        const ActiveSet nodes =
          pair->points.nodes_around(part_of(of_pairs, *pair));
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (nodes[n])
            result[n] = 1;
      }
    return result;
  }


  unsigned int
  ContactInteraction::update_active_set(State           &state,
                                        const Loads     &loads,
                                        const ActiveSet &held) const
  {
    const unsigned int n_changes =
      sum_of_pairs(*this, [&](const ContactPair &pair) {
        return pair.update_active_set(state, loads, part_of(held, pair));
      });
    // all ranks must agree on whether the iteration goes on
    return Utilities::MPI::sum(n_changes, mesh.communicator);
  }


  unsigned int
  ContactInteraction::settle(State &state, const Loads &loads) const
  {
    const unsigned int n_changes =
      sum_of_pairs(*this, [&](const ContactPair &pair) {
        return pair.settle(state, loads);
      });
    return Utilities::MPI::sum(n_changes, mesh.communicator);
  }


  std::string
  ContactInteraction::passed_body(const State &before,
                                  const Loads &loads_before,
                                  const State &after,
                                  const Loads &loads_after) const
  {
    for (const auto &pair : pairs)
      if (pair.get() != &ground() &&
          Utilities::MPI::logical_or(
            was_passed(*pair, before, loads_before, after, loads_after),
            mesh.communicator))
        return pair->name;
    return {};
  }


  void
  ContactInteraction::compute_multipliers(State                &state,
                                          const Loads          &loads,
                                          const Linearizations &before,
                                          const LA::Vector     &increment) const
  {
    for (const auto &pair : pairs)
      pair->compute_multipliers(state, loads, before[pair->number], increment);
  }


  void
  ContactInteraction::make_slipping_points_stick(State &state) const
  {
    for (ContactState &zone : state.contacts)
      zone.make_slipping_points_stick();
  }


  bool
  ContactInteraction::release_glue(State &state, const ActiveSet &nodes) const
  {
    bool any = false;
    for (const auto &pair : pairs)
      any = pair->state_of(state).release_glue(part_of(nodes, *pair)) || any;
    return Utilities::MPI::logical_or(any, mesh.communicator);
  }


  unsigned int
  ContactInteraction::count_active(const State &state) const
  {
    return sum_of_pairs(*this, [&](const ContactPair &pair) {
      return Biface::count_active(pair, state);
    });
  }


  unsigned int
  ContactInteraction::count_slipping(const State &state,
                                     const Loads &loads) const
  {
    return sum_of_pairs(*this, [&](const ContactPair &pair) {
      return Biface::count_slipping(pair, state, loads);
    });
  }
} // namespace Biface
