// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_with_history_h
#define biface_contact_friction_with_history_h

#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/tangential_law.h>

namespace Biface
{
  /** Friction of a shell that stands: each node has a stick point on the body,
   * see FrictionLaw. Nodes may be glued to theirs. */
  class FrictionWithHistory : public TangentialLaw
  {
  public:
    /** The law of a stage.
     * @param glued whether the nodes in contact at the start of the stage
     * cannot slip. */
    FrictionWithHistory(const FrictionLaw      &law,
                        const ContactCondition &condition,
                        const bool              glued)
      : law(law), condition(condition), glued(glued)
    {}

    bool
    acts_on(const ContactState &state, const unsigned int node) const override
    {
      return state.statuses[node] != ContactStatus::none;
    }

    void
    start_stage(ContactState &state) const override;

    void
    stick_all(ContactState &state) const override;

    /** Decide whether a node sticks or slips. A node that slips sticks in the
     * next iteration if it has passed its stick point: friction does not
     * push. */
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

    void
    commit_step(ContactState &state, const PointInContact &at) const override;

    dealii::Tensor<1, 3>
    slip_in_step(const ContactState &before,
                 const ContactState &after,
                 const RigidBody    &body,
                 const unsigned int  node) const override;

  private:
    /** The vector from the stick point of a node to the node, and its
     * tangential part. */
    struct Slip
    {
      dealii::Tensor<1, 3> total, tangential;
    };

    static Slip
    slip(const ContactState &state, const PointInContact &at);

    const FrictionLaw      law;
    const ContactCondition condition;
    const bool             glued;
  };
} // namespace Biface

#endif
