// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_by_slip_velocity_h
#define biface_contact_friction_by_slip_velocity_h

#include <biface/contact/contact_condition.h>
#include <biface/contact/friction_without_history.h>

namespace Biface
{
  /** Friction of a shell that rolls, by the velocity with which its particles
   * slip over the ground, see SlipVelocityLaw. Nodes without a particle have no
   * friction. */
  class FrictionBySlipVelocity : public FrictionWithoutHistory
  {
  public:
    FrictionBySlipVelocity(const FrictionLaw      &law,
                           const ContactCondition &condition)
      : FrictionWithoutHistory(law), condition(condition)
    {}

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

  private:
    const ContactCondition condition;
  };
} // namespace Biface

#endif
