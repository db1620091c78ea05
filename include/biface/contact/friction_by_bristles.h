// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_by_bristles_h
#define biface_contact_friction_by_bristles_h

#include <biface/contact/bristles.h>
#include <biface/contact/contact_condition.h>
#include <biface/contact/friction.h>
#include <biface/contact/tangential_law.h>

namespace Biface
{
  /** Friction of a shell that rolls, by the deflections of bristles, see
   * BristleLaw. They follow from whole lines of nodes; the tangential
   * multipliers of the state are their tractions. Nodes on no line of flow have
   * no friction. */
  class FrictionByBristles : public TangentialLaw
  {
  public:
    FrictionByBristles(const FrictionLaw      &law,
                       const ContactCondition &condition)
      : law(law), condition(condition), of_bristles(this->law, this->condition)
    {}

    /** Not copied: its law of bristles refers to its other members. */
    FrictionByBristles(const FrictionByBristles &) = delete;

    bool
    has_friction() const override
    {
      return true;
    }

    /** Let all nodes forget how they stick. */
    void
    start_stage(ContactState &state) const override;

    /** Set a stick point with which the node keeps its traction as long as
     * nothing moves, so that a stage that stands can follow. */
    void
    commit_step(ContactState &state, const PointInContact &at) const override;

    const BristleLaw *
    bristles() const override
    {
      return &of_bristles;
    }

    double
    stiffness_of_bristles() const override
    {
      return law.stiffness();
    }

    std::shared_ptr<const TangentialLaw>
    with_part_of_friction(const double part) const override
    {
      return std::make_shared<const FrictionByBristles>(
        law.with_part_of_friction(part), condition);
    }

  private:
    const FrictionLaw      law;
    const ContactCondition condition;
    const BristleLaw       of_bristles;
  };
} // namespace Biface

#endif
