// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_interaction_h
#define biface_model_contact_contact_interaction_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/rigid_foundation.h>
#include <biface/model/contact/rolling_kinematics.h>
#include <biface/model/contact/tangential_law.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/state.h>

namespace Biface
{
  /** The figures of a contact zone. */
  struct ContactSummary
  {
    /** Compressive force on the foundation, along its direction. */
    double       force   = 0;
    unsigned int n_nodes = 0;
    /** The number of nodes that slip at the limit of friction; 0 without
     * friction. */
    unsigned int n_slipping = 0;
    /** Sum of the areas of the active nodes on the middle surface. */
    double area = 0;
    /** The part of @p area that belongs to slipping nodes. */
    double slipping_area = 0;
    double max_pressure  = 0;
    /** The mean of the nodal pressures @f$p@f$, each weighted by the force
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


  /** Whether a node slips at the limit of friction. */
  inline bool
  slips(const State &state, const Loads &loads, const unsigned int node)
  {
    return has_friction(loads) && state.active[node] &&
           state.grips[node] == Grip::slip;
  }


  /** The traction of the foundation on the shell. Unit: force/area. */
  struct ContactTraction
  {
    dealii::Tensor<1, 3> total;
    /** Its tangential part. */
    dealii::Tensor<1, 3> friction;
  };

  /** The traction at a node, by its position in ShellMesh::nodes, from the
   * multipliers of the state; zero at inactive nodes. */
  ContactTraction
  contact_traction(const ShellMesh   &mesh,
                   const State       &state,
                   const Loads       &loads,
                   const unsigned int node);


  /**
   * The contact between the outer face of the shell and the foundation: the
   * active set, the tractions, and the figures of the contact zone. It has no
   * state of its own. ContactForces computes the nodal forces.
   */
  class ContactInteraction
  {
  public:
    struct Parameters
    {
      RigidFoundation::Parameters  foundation;
      ContactCondition::Parameters condition;
      FrictionLaw::Parameters      friction;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The mesh is kept by reference. Throws InputError if the parameters are
     * invalid. */
    ContactInteraction(const ShellMesh &mesh, const Parameters &parameters);

    /** The foundation after the given travel from its initial position. */
    RigidFoundation
    foundation(const double travel) const
    {
      return foundation_at_rest.moved(travel);
    }

    /** The law by which the foundation holds the nodes sideways. The object
     * must outlive it. Throws InputError if the coefficient is invalid.
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

    /** The travel at which the foundation just touches a free node of the
     * deformed outer face, one that can come into contact. Throws InputError if
     * it misses the shell, or if the shell does not fit into it. */
    double
    touching_travel(const State &state) const;

    /** The mean of the deformed positions of the nodes that the foundation
     * touches at the given travel. */
    dealii::Point<3>
    touched_point(const State &state, const double touching_travel) const;

    /** The nodes of this rank that the foundation has passed through: supports
     * hold their outer face, so they cannot come into contact. */
    ActiveSet
    pierced_nodes(const State &state, const Loads &loads) const;

    /** The travel from the present place of the foundation until it touches a
     * free node of the outer face, see RigidFoundation::travel_to(). */
    double
    remaining_travel(const State &state, const Loads &loads) const;

    /** Distance between the deformed outer face at a node and the
     * foundation. */
    double
    clearance(const State &state, const Loads &loads, const Node &node) const;

    /** The contact at an active node, linearized in the motion of the node
     * against the foundation. */
    struct Linearization
    {
      /** The point of the foundation at rest at the node. */
      dealii::Point<3>     at_rest;
      double               clearance;
      dealii::Tensor<1, 3> normal;
    };

    /** The contact at all nodes of this rank; of use at active nodes only. */
    std::vector<Linearization>
    linearize(const State &state, const Loads &loads) const;

    /** After an increment, set the multipliers along the normal of the active
     * nodes to those of the linear system, which are linear in the motions of
     * shell and foundation, and those of the other nodes to zero.
     * @param before the contact before the increment. */
    void
    predict_multipliers(State                            &state,
                        const Loads                      &loads,
                        const std::vector<Linearization> &before) const;

    /** One iteration of the primal-dual active set method: update the active
     * set from multipliers and clearances, decide which of its nodes stick and
     * which slip, and compute their tangential multipliers. Nodes that enter
     * have no multiplier yet. A node that slips sticks in the next iteration if
     * it has passed its stick point: friction does not push.
     * @param held nodes that remain active in any case; empty for none.
     * @return the number of changes of the active set, and of nodes that stick
     * only for this reason, on all ranks. */
    unsigned int
    update_active_set(State           &state,
                      const Loads     &loads,
                      const ActiveSet &held = {}) const;

    /** Set the multipliers to those of the displacements and update the active
     * set, which then is that of the penetrated nodes.
     * @return the number of changes, see update_active_set(). */
    unsigned int
    settle(State &state, const Loads &loads) const;

    /** After tiny increments of the displacements and of the travel of the
     * foundation, compute the multipliers for the active set and the slipping
     * nodes of the state. Those along the normal are linear in the increments:
     * the round-off of positions, which is large beside the penetration, is
     * that before.
     * @param before the contact before the increments.
     * @param increment of the displacements, a vector with ghosts. */
    void
    compute_multipliers(State                            &state,
                        const Loads                      &loads,
                        const std::vector<Linearization> &before,
                        const LA::Vector                 &increment,
                        const double                      travel) const;

    /** Let all nodes stick that have a stick point, where nothing is known
     * about the slip: too many slipping nodes have too little stiffness. */
    void
    let_stick(State &state) const;

    /** Let the nodes remember the end of a step, see
     * TangentialLaw::commit_step(); those that have left forget how they
     * stuck. */
    void
    commit_step(State &state, const Loads &loads) const;

    /** Let nodes that are glued forget their stick points, like nodes that
     * leave the foundation and enter it again.
     * @return whether there are any, on all ranks. */
    bool
    release_glue(State &state, const ActiveSet &nodes) const;

    /** Number of active nodes on all ranks. */
    unsigned int
    count_active(const State &state) const;

    /** Number of nodes that slip at the limit of friction, on all ranks. */
    unsigned int
    count_slipping(const State &state, const Loads &loads) const;

    /** The work of friction in a step, that is, the heat: at each node the
     * traction at the end of the step times the motion of the stick point. */
    double
    friction_work(const State &before,
                  const State &after,
                  const Loads &loads) const;

    /** The traction at a node, @f$\varepsilon c\,\mathbf n+\mathbf t@f$ with
     * the clearance c. Without friction the stiffness is
     * @f$\varepsilon\,\mathbf n\mathbf n^T-\lambda\nabla\mathbf n@f$.
     * @param node the position of an active node in ShellMesh::nodes. */
    LinearizedTraction
    traction(const State       &state,
             const Loads       &loads,
             const unsigned int node) const;

    /** The figures from the multipliers of the state. */
    ContactSummary
    summarize(const State &state, const Loads &loads) const;

    const ShellMesh       &mesh;
    const ContactCondition condition;
    /** Of a shell that rolls. */
    const RollingKinematics rolling;

  private:
    double
    minimum_travel(const State &state, const RigidFoundation &foundation) const;

    NodeInContact
    contact_at(const State       &state,
               const Loads       &loads,
               const unsigned int node) const;

    /** Set the tangential multipliers of an active node to its tangential
     * traction. */
    void
    set_tangential_multipliers(State               &state,
                               const Loads         &loads,
                               const NodeInContact &at) const;

    const RigidFoundation         foundation_at_rest;
    const FrictionLaw::Parameters friction_parameters;
  };
} // namespace Biface

#endif
