// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_by_slip_velocity_h
#define biface_contact_friction_by_slip_velocity_h

#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/tangential_law.h>

namespace Biface
{
  /** Friction of a shell that rolls, by the velocity with which its particles
   * slip over the ground, see SlipVelocityLaw. It has no history. Nodes without
   * a particle have no friction. */
  class FrictionBySlipVelocity : public TangentialLaw
  {
  public:
    FrictionBySlipVelocity(const FrictionLaw      &law,
                           const ContactCondition &condition)
      : law(law), condition(condition)
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
    acts_on(const ContactState & /*state*/,
            const unsigned int /*node*/) const override
    {
      return true;
    }

    /** Let all nodes forget how they stick. */
    void
    start_stage(ContactState &state) const override;

    bool
    decide(ContactState               &state,
           const PointInContact       &at,
           const dealii::Tensor<1, 3> &last) const override;

    dealii::Tensor<1, 3>
    traction(const ContactState   &state,
             const PointInContact &at) const override;

    void
    linearize(const ContactState   &state,
              const PointInContact &at,
              LinearizedTraction   &traction) const override;

    /** Set a stick point with which the node keeps its traction as long as
     * nothing moves, so that a stage that stands can follow. */
    void
    commit_step(ContactState &state, const PointInContact &at) const override;

    std::optional<double>
    critical_velocity() const override
    {
      return law.critical_velocity;
    }

    std::shared_ptr<const TangentialLaw>
    with_critical_velocity(const double velocity) const override;

  private:
    const FrictionLaw      law;
    const ContactCondition condition;
  };
} // namespace Biface

#endif
