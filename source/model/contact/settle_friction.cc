// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/contact_laws.h>
#include <biface/model/contact/contact_over_step.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/settle_friction.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  void
  settle_friction_over_step(const ContactPair &contact,
                            const Loads       &loads,
                            State             &state)
  {
    // bristles are those of the contact at the end of the step already
    if (!contact.has_friction(loads) || contact.body(loads)->laws.bristles())
      return;
    const PlacedBody &body = *contact.body(loads);
    ContactState     &zone = contact.state_of(state);
    for (unsigned int n = 0; n < contact.points.size(); ++n)
      {
        const auto at = over_step(contact, state, loads, n);
        // in time there is no active set: what penetrates over the step touches
        zone.active[n]   = at && at->clearance < 0;
        zone.statuses[n] = ContactStatus::none;
        for (unsigned int i = 1; i < 3; ++i)
          zone.multipliers[n][i] = 0;
        if (!zone.active[n])
          continue;
        const FrictionOverStep &friction = *at->friction;
        zone.statuses[n]                 = friction.status;
        zone.stick_points[n] =
          body.body.at_rest(friction.new_stick_point(body.laws.friction()));
        const auto tangents = body.body.tangents(friction.normal);
        for (unsigned int i = 0; i < 2; ++i)
          zone.multipliers[n][1 + i] = friction.traction() * tangents[i];
      }
  }


  double
  friction_work_over_step(const ContactPair &contact,
                          const State       &state,
                          const Loads       &loads)
  {
    if (!contact.has_friction(loads) || contact.body(loads)->laws.bristles())
      return 0;
    const FrictionLaw &law = contact.body(loads)->laws.friction();
    return sum_over_points(contact, [&](const unsigned int point) {
      const auto at = over_step(contact, state, loads, point);
      if (!at || at->friction->status != ContactStatus::slip)
        return 0.;
      return -(at->friction->traction() *
               (at->friction->new_stick_point(law) - at->friction->stick));
    });
  }
} // namespace Biface
