// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_pair_h
#define biface_model_contact_contact_pair_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/body_parameters.h>
#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/rigid_body.h>
#include <biface/contact/tangential_law.h>
#include <biface/contact/tread.h>
#include <biface/model/contact/bristle_lines.h>
#include <biface/model/mesh/flow_lines.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/contact_points.h>
#include <biface/model/state/state.h>

namespace Biface
{
  class EntryDeclarations;


  /** The figures of a contact zone. */
  struct ContactSummary
  {
    /** The compressive force on the body, along its direction. Unit: force. */
    double force = 0;
    /** The number of active nodes, or of active points in cells. */
    unsigned int n_nodes = 0;
    /** The number of points that slip at the limit of friction; 0 without
     * friction. */
    unsigned int n_slipping = 0;
    /** The sum of the areas of the active points on the middle surface. Unit:
     * area. */
    double area = 0;
    /** The part of @p area that belongs to slipping points. */
    double slipping_area = 0;
    double max_pressure  = 0;
    /** The mean of the pressures @f$p@f$ at the points, each weighted by the
     * force
     * @f$pA@f$ that it carries: @f$\sum p^2A/\sum pA@f$. For a given force it
     * is lowest if the pressure is the same on as large an area as possible.
     * Nodes that enter or leave do so without pressure and do not change it.
     * Unit: force/area. */
    double weighted_pressure = 0;
    /** The standard deviation of the nodal pressures with the same weights, in
     * parts of this mean: zero if all of the ground that carries is under the
     * same pressure. No unit. */
    double pressure_variation = 0;
  };


  /** The traction of a body on the shell. Unit: force/area. */
  struct ContactTraction
  {
    dealii::Tensor<1, 3> total;
    /** The tangential part of the traction. */
    dealii::Tensor<1, 3> friction;
  };


  /** The traction at a point from its multipliers; zero if it is inactive, or
   * if the body, then null, is not there.
   * @param x the deformed position of the point. */
  ContactTraction
  contact_traction(const ContactState     &state,
                   const PlacedBody       *body,
                   const unsigned int      point,
                   const dealii::Point<3> &x);


  /** Whether a point slips at the limit of friction of a body, which is null if
   * it is not there. */
  inline bool
  slips(const ContactState &state,
        const PlacedBody   *body,
        const unsigned int  point)
  {
    return body && body->law->has_friction() && state.slips(point);
  }


  /** The contact at the nodes of this rank between the shell and a body: what
   * the state contains or, if the points are in cells, the nodal values that
   * exert the same forces, with nodes in contact that have a point in contact
   * around. Must be called on all ranks.
   * @param number see ContactPair::number. */
  ContactState
  contact_at_nodes(const ShellMesh   &mesh,
                   const State       &state,
                   const unsigned int number,
                   const PlacedBody  &body);


  /**
   * The contact between a face of the shell and a rigid body: the active set,
   * the tractions, and the figures of the contact zone. What happens there is a
   * ContactState, and where the body is belongs to the Loads; both are found by
   * the number of the pair. ContactForces computes the nodal forces.
   */
  class ContactPair
  {
  public:
    struct Parameters
    {
      RigidBody::Parameters        body;
      ContactCondition::Parameters condition;
      FrictionLaw::Parameters      friction;
      TreadParameters              tread;
      /** The face of the shell that touches the body. */
      Resultants::Face face = Resultants::outer;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The pair with the ground or with another body of given parameters. The
     * mesh is kept by reference. Throws InputError if the parameters are
     * invalid.
     * @param number the position of the pair in State::contacts and
     * Loads::bodies. */
    ContactPair(const ShellMesh   &mesh,
                const Parameters  &parameters,
                const unsigned int number);

    /** The pair with a body that is not the ground, whose laws of contact are
     * those of the ground, except the coefficient of friction. A tread lies
     * between both if the body touches it. */
    ContactPair(const ShellMesh      &mesh,
                const Parameters     &ground,
                const BodyParameters &body,
                const unsigned int    number);

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

    /** The body at its present place with its tangential law; null if it is not
     * there. */
    const PlacedBody *
    body(const Loads &loads) const
    {
      return loads.body(number);
    }

    /** Whether the body is there and holds nodes sideways. */
    bool
    has_friction(const Loads &loads) const
    {
      return body(loads) && body(loads)->law->has_friction();
    }

    /** Whether the body is there and holds nodes sideways by bristles on the
     * lines of flow. */
    bool
    has_bristles(const Loads &loads) const
    {
      return body(loads) && body(loads)->law->bristles() && loads.rolling;
    }

    /** The bristles of a body that has them, see has_bristles(). Must be called
     * on all ranks; the body must outlive the result. */
    BristleLines
    bristle_lines(const State &state, const Loads &loads) const
    {
      return BristleLines(mesh,
                          flow_lines,
                          face,
                          state,
                          state_of(state),
                          *body(loads),
                          *loads.rolling);
    }

    /** The body after the given travel from its initial position. */
    RigidBody
    body_at(const double travel) const
    {
      return body_at_rest.moved(travel);
    }

    /** Whether the body is not the foundation, but moves with it. */
    bool
    moves_with_foundation() const
    {
      return other_body && other_body->on_foundation;
    }

    /** A body on the body of this pair, the foundation, after the same
     * travel. */
    RigidBody
    taken_along(const RigidBody &body, const double travel) const;

    /** The body of a pair that is not the ground, after its motions by the
     * given factors. The foundation takes those along that are on it.
     * @param with_foundation the further motion of a body on the foundation. */
    RigidBody
    body_at(
      const std::vector<double>                         &factors,
      const std::function<RigidBody(const RigidBody &)> &with_foundation) const;

    /** The law by which the body holds the nodes sideways. Throws InputError if
     * the coefficient is invalid.
     * @param entry the entry of the coefficient.
     * @param coefficient that of a stage; empty for that of the parameters.
     * @param glued whether the nodes in contact at the start of the stage
     * cannot slip.
     * @param rolls whether the shell rolls. */
    std::shared_ptr<const TangentialLaw>
    law(const std::string &entry,
        const std::string &coefficient,
        const bool         glued,
        const bool         rolls) const;

    /** The travel at which the body just touches a free node of the deformed
     * face, one that can come into contact. Throws InputError if it misses the
     * shell, or if the shell does not fit into it. */
    double
    touching_travel(const State &state) const;

    /** The mean of the deformed positions of the nodes that the body touches at
     * the given travel. */
    dealii::Point<3>
    touched_point(const State &state, const double touching_travel) const;

    /** The nodes of this rank that the body has passed through: supports hold
     * their face, so they cannot come into contact. */
    ActiveSet
    pierced_nodes(const State &state, const Loads &loads) const;

    /** How deep a node of the face that may touch is in the body; 0 if none is.
     * Must be called on all ranks. Unit: length. */
    double
    penetration(const State &state, const Loads &loads) const;

    /** Whether a node of this rank has passed through the body: one that did
     * not touch it, on the straight line between its places relative to the
     * body, and one that did, if the normal has turned by more than 120
     * degrees. */
    bool
    was_passed(const State &before,
               const Loads &loads_before,
               const State &after,
               const Loads &loads_after) const;

    /** The travel from the present place of the body until it touches a free
     * node of the face, see RigidBody::travel_to(). Unit: length. */
    double
    remaining_travel(const State &state, const Loads &loads) const;

    /** The way of the body, at its present velocity, until a free node of the
     * face is in it by the given depth; infinite if it approaches none.
     * @param direction the rates of the loads per way. */
    double
    way_to_shell(const State     &state,
                 const Loads     &loads,
                 const LoadRates &direction,
                 const double     depth) const;

    /** The deformed position of the face at a node. */
    dealii::Point<3>
    position(const State &state, const Node &node) const
    {
      return mesh.deformed_position(state.displacement, node, face);
    }

    /** The distance between the deformed face at a point and the body. Unit:
     * length. */
    double
    clearance(const State       &state,
              const Loads       &loads,
              const unsigned int point) const
    {
      return body(loads)->body.clearance(
        points.position(state.displacement, point));
    }

    /** The geometry at a point that may touch the body, which must be there and
     * outlive the result. */
    PointInContact
    at_point(const State       &state,
             const Loads       &loads,
             const unsigned int point) const;

    /** The contact at an active point, linearized in its motion against the
     * body. */
    struct Linearization
    {
      dealii::Point<3>     position;
      double               clearance;
      dealii::Tensor<1, 3> normal;
      /** The motion of the body at the point in the increment that follows.
       * Unit: length. */
      dealii::Tensor<1, 3> of_body;
    };

    /** The linearizations by point of this rank; of use at active points
     * only. */
    using Linearizations = std::vector<Linearization>;

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

    /** Let all nodes stick that have a stick point, where nothing is known
     * about the slip: too many slipping nodes have too little stiffness. */
    void
    let_stick(State &state) const;

    /** Let the nodes remember the end of a step, see
     * TangentialLaw::commit_step(); those that have left forget how they
     * stuck. */
    void
    commit_step(State &state, const Loads &loads) const;

    /** Let glued nodes forget their stick points, like nodes that leave the
     * body and enter it again.
     * @return whether there are any on this rank. */
    bool
    release_glue(State &state, const ActiveSet &nodes) const;

    /** The number of active points on all ranks. */
    unsigned int
    count_active(const State &state) const;

    /** The number of points that slip, on all ranks. */
    unsigned int
    count_slipping(const State &state, const Loads &loads) const;

    /** The work of friction in a step, that is, the heat: at each node the
     * traction at the end of the step times the motion of the stick point. */
    double
    friction_work(const State &before,
                  const State &after,
                  const Loads &loads) const;

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

    /** The figures of the contact zone, from the multipliers of the state. */
    ContactSummary
    summarize(const State &state, const Loads &loads) const;

    const ShellMesh   &mesh;
    const unsigned int number;
    /** The name of the body. */
    const std::string      name;
    const Resultants::Face face;
    const TreadParameters  tread;
    const ContactCondition condition;
    const ContactPoints    points;
    /** The flow of the material through the mesh, if the shell rolls. */
    const FlowLines flow_lines;

  private:
    double
    minimum_travel(const State &state, const RigidBody &body) const;

    /** Set the tangential multipliers of an active node to its tangential
     * traction. */
    void
    set_tangential_multipliers(State                &state,
                               const TangentialLaw  &law,
                               const PointInContact &at) const;

    /** Set the tangential multipliers of all nodes if there are bristles. */
    void
    set_multipliers_of_bristles(State &state, const Loads &loads) const;

    const RigidBody               body_at_rest;
    const FrictionLaw::Parameters friction_parameters;
    /** The parameters of a body that is not the ground. */
    const std::optional<BodyParameters> other_body;
  };
} // namespace Biface

#endif
