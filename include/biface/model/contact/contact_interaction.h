// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_interaction_h
#define biface_model_contact_contact_interaction_h

#include <memory>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/active_set.h>
#include <biface/model/contact/linearized_contact.h>
#include <biface/model/state/load_rates.h>

namespace Biface
{
  struct BodyParameters;
  struct ContactParameters;
  class ContactPair;
  struct Loads;
  class ShellMesh;
  struct State;


  /** The contact of the shell with all rigid bodies. It has no state of its
   * own. Functions return the same on all ranks. */
  class ContactInteraction
  {
  public:
    /** The contact with the given pairs. The mesh is kept by reference. Throws
     * InputError if the parameters are invalid.
     * @param parameters those of each pair, the ground first; none for a shell
     * that touches nothing, or whose contact does not matter. */
    ContactInteraction(const ShellMesh                      &mesh,
                       const std::vector<ContactParameters> &parameters);

    /** The contact with the ground and with other bodies, whose laws are those
     * of the ground. The mesh is kept by reference. */
    ContactInteraction(const ShellMesh                   &mesh,
                       const ContactParameters           &ground,
                       const std::vector<BodyParameters> &bodies);

    /** The contact with the ground alone. The mesh is kept by reference. */
    ContactInteraction(const ShellMesh &mesh, const ContactParameters &ground);

    ~ContactInteraction();

    /** The pair with the body on which the shell is pressed, whose motion and
     * force stages prescribe. */
    const ContactPair &
    ground() const
    {
      return *pairs.front();
    }

    /** The pairs whose bodies are there. */
    std::vector<const ContactPair *>
    present(const Loads &loads) const;

    /** The state of the unloaded shell, with a ContactState for each pair. */
    State
    unloaded_state() const;

    /** Whether a body that is there holds nodes sideways. */
    bool
    has_friction(const Loads &loads) const;

    /** The linearizations of all pairs. */
    using Linearizations = std::vector<std::vector<LinearizedContact>>;

    /** The contact at the active points of all pairs, linearized, see
     * ContactPair::linearize(). */
    Linearizations
    linearize(const State     &state,
              const Loads     &loads,
              const LoadRates &change = LoadRates()) const;

    /** Set the multipliers of all pairs after an increment, see
     * ContactPair::predict_multipliers(). */
    void
    predict_multipliers(State                &state,
                        const Loads          &loads,
                        const Linearizations &before) const;

    /** The active sets of all pairs, one after the other. */
    ActiveSet
    active_points(const State &state) const;

    /** Set the active sets of all pairs from a list like that of
     * active_points(). */
    void
    set_active_points(State &state, const ActiveSet &active) const;

    /** The nodes around the points that are marked in any pair of a list like
     * active_points(), see ContactPoints::nodes_around(). */
    ActiveSet
    nodes_around(const ActiveSet &of_pairs) const;

    /** Update the active sets of all pairs, see
     * ContactPair::update_active_set().
     * @param held like active_points(), or empty. */
    unsigned int
    update_active_set(State           &state,
                      const Loads     &loads,
                      const ActiveSet &held = {}) const;

    /** Set the multipliers to those of the displacements and update the active
     * sets, see ContactPair::settle(). */
    unsigned int
    settle(State &state, const Loads &loads) const;

    /** The name of a body, other than the ground, through which the shell has
     * passed in a step, see was_passed(); empty for none. */
    std::string
    passed_body(const State &before,
                const Loads &loads_before,
                const State &after,
                const Loads &loads_after) const;

    /** Set the multipliers of all pairs after tiny increments, see
     * ContactPair::compute_multipliers(). */
    void
    compute_multipliers(State                &state,
                        const Loads          &loads,
                        const Linearizations &before,
                        const LA::Vector     &increment) const;

    /** Let all nodes of all pairs stick that have a stick point, see
     * ContactState::make_slipping_points_stick(). */
    void
    make_slipping_points_stick(State &state) const;

    /** Let glued nodes of all pairs forget their stick points, see
     * ContactState::release_glue().
     * @param nodes like active_points(). */
    bool
    release_glue(State &state, const ActiveSet &nodes) const;

    /** The number of active points of all pairs. */
    unsigned int
    count_active(const State &state) const;

    /** The number of points of all pairs that slip. */
    unsigned int
    count_slipping(const State &state, const Loads &loads) const;

    const ShellMesh &mesh;
    /** The pairs in contact, of which the first is that with the ground. */
    const std::vector<std::unique_ptr<const ContactPair>> pairs;

  private:
    /** The part of a list of all pairs that belongs to one of them. */
    ActiveSet
    part_of(const ActiveSet &of_pairs, const ContactPair &pair) const;
  };
} // namespace Biface

#endif
