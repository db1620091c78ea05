// SPDX-License-Identifier: LGPL-2.1-or-later

// The primal-dual decision releases an active node that is pulled and holds one
// that is pressed, whatever the clearance, which is not yet that of the
// multiplier; a node apart enters where it has penetrated. Where the multiplier
// is that of the clearance, the sign of the clearance decides.

#include <biface/contact/contact_condition.h>
#include <biface/contact/contact_condition_parameters.h>

#include <tests.h>

using namespace Biface;

int
main()
{
  const ContactCondition condition(ContactCondition::Parameters(), 1);
  const double           p = 0.3;

  // the clearance that an active node with such a multiplier has
  const double c = p / condition.penalty_stiffness();
  check_true("pressed, and less deep than the pressure asks for: held",
             condition.should_be_active(-p, -c / 2));
  check_true("pressed, the ground just reached: held",
             condition.should_be_active(-p, 0));
  check_true("pulled, the ground just reached: released",
             !condition.should_be_active(p, 0));
  check_true("pressed, far from the ground: held",
             condition.should_be_active(-p, 1e4 * c));
  check_true("pulled, though deep inside: released",
             !condition.should_be_active(p, -1e4 * c));
  check_true("apart, penetrated: enters", condition.should_be_active(0, -c));
  check_true("apart, clear of it: stays apart",
             !condition.should_be_active(0, c));
  check_true("apart, just touching: stays apart",
             !condition.should_be_active(0, 0));

  bool by_clearance = true;
  for (int i = -300; i <= 300; ++i)
    for (const double sign : {-1., 1.})
      {
        const double clearance = sign * std::pow(10., i);
        by_clearance =
          by_clearance &&
          condition.should_be_active(condition.multiplier(clearance),
                                     clearance) == (clearance < 0) &&
          condition.should_be_active(0, clearance) == (clearance < 0);
      }
  check_true("multiplier of the clearance: its sign decides", by_clearance);
}
