// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_friction_by_slip_velocity_h
#define biface_model_contact_friction_by_slip_velocity_h

#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/model/contact/rolling_kinematics.h>
#include <biface/model/contact/tangential_law.h>

namespace Biface
{
  /** Friction of a shell that rolls, by the velocity with which its particles
   * slip over the ground, see SlipVelocityLaw. It has no history. Nodes without
   * a stencil, see FlowLines, have no friction. */
  class FrictionBySlipVelocity : public TangentialLaw
  {
  public:
    /** @param kinematics kept by reference. */
    FrictionBySlipVelocity(const FrictionLaw       &law,
                           const ContactCondition  &condition,
                           const RollingKinematics &kinematics)
      : law(law), condition(condition), kinematics(kinematics)
    {}

    bool
    has_friction() const override
    {
      return true;
    }

    bool
    depends_on_velocity() const override
    {
      return true;
    }

    bool
    acts_on(const State & /*state*/, const unsigned int /*node*/) const override
    {
      return true;
    }

    /** Let all nodes forget how they stick. */
    void
    start_stage(State &state) const override;

    bool
    decide(State                      &state,
           const Loads                &loads,
           const NodeInContact        &at,
           const dealii::Tensor<1, 3> &last) const override;

    dealii::Tensor<1, 3>
    traction(const State         &state,
             const Loads         &loads,
             const NodeInContact &at) const override;

    void
    linearize(const State         &state,
              const Loads         &loads,
              const NodeInContact &at,
              LinearizedTraction  &traction) const override;

    /** Set a stick point with which the node keeps its traction as long as
     * nothing moves, so that a stage that stands can follow. */
    void
    commit_step(State               &state,
                const Loads         &loads,
                const NodeInContact &at) const override;

    std::optional<double>
    critical_velocity() const override
    {
      return law.critical_velocity;
    }

    std::shared_ptr<const TangentialLaw>
    with_critical_velocity(const double velocity) const override;

  private:
    const FrictionLaw        law;
    const ContactCondition   condition;
    const RollingKinematics &kinematics;
  };
} // namespace Biface

#endif
