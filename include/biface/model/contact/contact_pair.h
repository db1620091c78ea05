// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_pair_h
#define biface_model_contact_contact_pair_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_condition_parameters.h>
#include <biface/contact/tread.h>
#include <biface/model/contact/contact_traction.h>
#include <biface/model/contact/linearized_contact.h>
#include <biface/model/contact/moving_body.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/streamlines.h>
#include <biface/model/state/contact_points.h>
#include <biface/model/state/load_rates.h>
#include <biface/model/state/state.h>

namespace Biface
{
  struct BodyParameters;
  class BristleLines;
  class ContactLaws;
  struct ContactLawsOfStage;
  struct ContactParameters;
  struct FrictionParameters;
  struct LinearizedTraction;
  struct Loads;
  struct PointInContact;
  class TangentialLaw;


  /**
   * The contact between a face of the shell and a rigid body: the active set,
   * the tractions, and the figures of the contact zone. What happens there is a
   * ContactState, and where the body is belongs to the Loads; both are found by
   * the number of the pair. ContactForces computes the nodal forces.
   */
  class ContactPair
  {
  public:
    /** The pair with the ground or with another body of given parameters. The
     * mesh is kept by reference. Throws InputError if the parameters are
     * invalid.
     * @param number the position of the pair in State::contacts and
     * Loads::bodies. */
    ContactPair(const ShellMesh         &mesh,
                const ContactParameters &parameters,
                const unsigned int       number);

    /** The pair with a body that is not the ground, whose laws of contact are
     * those of the ground, except the coefficient of friction. A tread lies
     * between both if the body touches it. */
    ContactPair(const ShellMesh         &mesh,
                const ContactParameters &ground,
                const BodyParameters    &body,
                const unsigned int       number);

    /** The contact state of this pair. */
    const ContactState &
    state_of(const State &state) const
    {
      return state.contacts[number];
    }

    ContactState &
    state_of(State &state) const
    {
      return state.contacts[number];
    }

    /** The body at its present place with the laws of its contact; null if it
     * is not there. */
    const PlacedBody *
    body(const Loads &loads) const;

    /** What messages call the body: the ground, or the body with its name. */
    std::string
    description() const
    {
      return number == 0 ? "the ground" : "the body '" + name + "'";
    }

    /** Whether the body is there and holds nodes sideways. */
    bool
    has_friction(const Loads &loads) const;

    /** The bristles on the streamlines. Must be called on all ranks; the body
     * must outlive the result. */
    BristleLines
    bristle_lines(const State &state, const Loads &loads) const;

    /** The laws of contact in a stage.
     * @param rolls whether the shell rolls. */
    ContactLaws
    laws(const ContactLawsOfStage &of_stage, const bool rolls = false) const;

    /** The laws of contact of which a stage sets nothing. */
    ContactLaws
    laws() const;

    /** The parameter @f$\varepsilon_t@f$ of FrictionLaw in a stage, with the
     * tread. Unit: pressure/length. */
    double
    tangential_stiffness(const ContactLawsOfStage &of_stage) const;

    /** Where the tangential stiffness changes, let those that
     * stick keep their tractions: move their stick points.
     * @param ratio the stiffness before over that from now on. */
    void
    keep_tangential_tractions(State       &state,
                              const Loads &loads,
                              const double ratio) const;

    /** The distance between the deformed face at a point and the body. Unit:
     * length. */
    double
    clearance(const State       &state,
              const Loads       &loads,
              const unsigned int point) const;

    /** The geometry at a point that may touch the body, which must be there and
     * outlive the result. */
    PointInContact
    at_point(const State       &state,
             const Loads       &loads,
             const unsigned int point) const;

    /** The linearizations by point of this rank; of use at active points
     * only. */
    using Linearizations = std::vector<LinearizedContact>;

    /** The contact at the active points, linearized.
     * @param change that of the loads in the increment that follows. */
    Linearizations
    linearize(const State     &state,
              const Loads     &loads,
              const LoadRates &change = LoadRates()) const;

    /** After an increment, set the multipliers along the normal of the active
     * nodes to those of the linear system, which are linear in the motions of
     * shell and body, and those of the other nodes to zero.
     * @param before the contact before the increment, with the change of the
     * loads. */
    void
    predict_multipliers(State                &state,
                        const Loads          &loads,
                        const Linearizations &before) const;

    /** One iteration of the primal-dual active set method: update the active
     * set from multipliers and clearances, decide which of its nodes stick and
     * which slip, and compute their tangential multipliers. Nodes that enter
     * have no multiplier yet. A node that slips sticks in the next iteration if
     * it has passed its stick point: friction does not push.
     * @param held nodes that remain active in any case; empty for none.
     * @return the number of changes of the active set, and of nodes that stick
     * only for this reason, among the nodes that belong to this rank. */
    unsigned int
    update_active_set(State           &state,
                      const Loads     &loads,
                      const ActiveSet &held = {}) const;

    /** Set the multipliers to those of the displacements and update the active
     * set, which then is that of the penetrated nodes.
     * @return the number of changes, see update_active_set(). */
    unsigned int
    settle(State &state, const Loads &loads) const;

    /** After tiny increments of the displacements and of the loads, compute the
     * multipliers for the active set and the slipping nodes of the state. Those
     * along the normal are linear in the increments: the round-off of
     * positions, which is large beside the penetration, is that before.
     * @param before the contact before the increments, with that of the loads.
     * @param increment of the displacements, a vector with ghosts. */
    void
    compute_multipliers(State                &state,
                        const Loads          &loads,
                        const Linearizations &before,
                        const LA::Vector     &increment) const;

    /** Let the nodes remember the end of a step, see
     * TangentialLaw::commit_step(); those that have left forget how they
     * stuck. */
    void
    commit_step(State &state, const Loads &loads) const;

    /** The traction at a point, @f$\varepsilon c\,\mathbf n+\mathbf t@f$ with
     * the clearance c. Without friction the stiffness is
     * @f$\varepsilon\,\mathbf n\mathbf n^T-\lambda\nabla\mathbf n@f$.
     * @param point the number of an active point. */
    LinearizedTraction
    traction(const State       &state,
             const Loads       &loads,
             const unsigned int point) const;

    /** The traction at a point from its multipliers, see contact_traction(). */
    ContactTraction
    traction_of_multipliers(const State       &state,
                            const Loads       &loads,
                            const unsigned int point) const
    {
      return contact_traction(state_of(state),
                              body(loads),
                              point,
                              points.position(state.displacement, point));
    }

    const ShellMesh   &mesh;
    const unsigned int number;
    /** The name of the body. */
    const std::string      name;
    const Resultants::Face face;
    const TreadParameters  tread;
    const MortarMatrix     mortar_matrix;
    const ContactPoints    points;
    const MovingBody       moving_body;
    /** The transport of the material through the mesh, if the shell rolls. */
    const Streamlines streamlines;

  private:
    /** Set the tangential multipliers of an active node to its tangential
     * traction. */
    void
    set_tangential_multipliers(State                &state,
                               const TangentialLaw  &law,
                               const PointInContact &at) const;

    /** The zone of contact that the clearances have, with their pressures. */
    ContactState
    zone_at_clearances(const State &state, const Loads &loads) const;

    const ContactConditionParameters                condition_parameters;
    const std::shared_ptr<const FrictionParameters> friction_parameters;
  };
} // namespace Biface

#endif
