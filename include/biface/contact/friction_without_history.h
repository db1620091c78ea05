// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_friction_without_history_h
#define biface_contact_friction_without_history_h

#include <biface/contact/friction.h>
#include <biface/contact/tangential_law.h>

namespace Biface
{
  /** Friction of a shell that rolls, whose nodes remember nothing. By itself it
   * has no tractions at nodes, as if all were on the streamlines, see
   * BristleLaw. */
  class FrictionWithoutHistory : public TangentialLaw
  {
  public:
    explicit FrictionWithoutHistory(const FrictionLaw &law) : law(law)
    {}

    /** Let all nodes forget how they stick. */
    void
    start_stage(ContactState &state) const override;

    /** Set a stick point with which the node keeps its traction as long as
     * nothing moves, so that a stage that stands can follow. */
    void
    commit_step(ContactState &state, const PointInContact &at) const override;

  protected:
    const FrictionLaw law;
  };
} // namespace Biface

#endif
