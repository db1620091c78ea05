// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_tangential_law_h
#define biface_model_contact_tangential_law_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <optional>

#include <biface/contact/rigid_foundation.h>
#include <biface/model/state/state.h>

namespace Biface
{
  /** A node in contact. */
  struct NodeInContact
  {
    /** Its position in ShellMesh::nodes. */
    unsigned int node;
    /** The deformed position of the face, and the foundation there. */
    dealii::Point<3> x;
    FoundationPoint  foundation;
  };


  /** The traction of the foundation on the shell at a node in contact, as it
   * enters the linear system from which the multiplier @f$\lambda@f$ of the
   * next iterate is eliminated. */
  struct LinearizedTraction
  {
    /** The traction with the multiplier extrapolated linearly from that of the
     * state to that of the clearance, which it is in converged states. Unit:
     * force/area. */
    dealii::Tensor<1, 3> value;
    /** Minus its derivative with respect to the position of the node, with the
     * multiplier of the state. */
    dealii::Tensor<2, 3> stiffness;
    /** Minus the derivatives with respect to the positions of the adjacent
     * nodes along the flow, behind and ahead. */
    std::array<dealii::Tensor<2, 3>, 2> stiffness_of_neighbors{};
    /** The derivatives with respect to the velocity of the particle at the node
     * and to the angular velocity. */
    dealii::Tensor<2, 3> per_velocity;
    dealii::Tensor<1, 3> per_angular_velocity;
  };


  /** How the foundation holds the nodes in contact sideways. Without friction,
   * it does not. */
  class TangentialLaw
  {
  public:
    virtual ~TangentialLaw() = default;

    /** Whether there can be tangential tractions. */
    virtual bool
    has_friction() const
    {
      return false;
    }

    /** Whether they follow from the velocity with which a rolling shell slips,
     * rather than from displacements. */
    virtual bool
    depends_on_velocity() const
    {
      return false;
    }

    /** Whether there is a tangential traction at an active node. */
    virtual bool
    acts_on(const State & /*state*/, const unsigned int /*node*/) const
    {
      return false;
    }

    /** Set what the nodes remember at the start of a stage. */
    virtual void
    start_stage(State &state) const;

    /** Let the nodes of a copy of an equilibrium stick, to hold them in
     * perturbations of it. */
    virtual void
    hold(State & /*state*/) const
    {}

    /** Decide whether an active node on which the law acts sticks or slips,
     * given its multipliers in the last iterate.
     * @return whether the iteration has to go on until the node obeys the law.
     */
    virtual bool
    decide(State & /*state*/,
           const Loads & /*loads*/,
           const NodeInContact & /*at*/,
           const dealii::Tensor<1, 3> & /*last*/) const
    {
      return false;
    }

    /** The tangential traction at an active node on which the law acts, with
     * the multiplier of the state. */
    virtual dealii::Tensor<1, 3>
    traction(const State & /*state*/,
             const Loads & /*loads*/,
             const NodeInContact & /*at*/) const
    {
      return {};
    }

    /** Add the tangential traction at an active node and its derivatives. */
    virtual void
    linearize(const State & /*state*/,
              const Loads & /*loads*/,
              const NodeInContact & /*at*/,
              LinearizedTraction & /*traction*/) const
    {}

    /** Set what an active node remembers at the end of a step. Nodes slide
     * freely without friction and in the step in which they enter. */
    virtual void
    commit_step(State               &state,
                const Loads         &loads,
                const NodeInContact &at) const;

    /** The motion over the foundation at rest of a node that has slipped in a
     * step, whose work with the traction is heat. */
    virtual dealii::Tensor<1, 3>
    slip_in_step(const State & /*before*/,
                 const State & /*after*/,
                 const Loads & /*loads*/,
                 const unsigned int /*node*/) const
    {
      return {};
    }

    /** The critical velocity of a law that has one, and the law with another
     * one. */
    virtual std::optional<double>
    critical_velocity() const
    {
      return {};
    }

    virtual std::shared_ptr<const TangentialLaw>
    with_critical_velocity(const double /*velocity*/) const
    {
      return nullptr;
    }
  };


  /** The law of the loads. */
  inline const TangentialLaw &
  law_of(const Loads &loads)
  {
    static const TangentialLaw frictionless;
    return loads.law ? *loads.law : frictionless;
  }


  /** Whether the foundation, if there is one, holds nodes sideways. */
  inline bool
  has_friction(const Loads &loads)
  {
    return loads.foundation && law_of(loads).has_friction();
  }


  /** Let a node forget how it sticks. */
  void
  forget_stick_point(State &state, const unsigned int node);
} // namespace Biface

#endif
