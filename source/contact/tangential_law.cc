// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/tangential_law.h>

namespace Biface
{
  using namespace dealii;

  void
  TangentialLaw::start_stage(ContactState &state) const
  {
    for (ContactStatus &status : state.statuses)
      if (status == ContactStatus::glued)
        status = ContactStatus::stick;
  }


  void
  TangentialLaw::commit_step(ContactState         &state,
                             const PointInContact &at) const
  {
    state.statuses[at.point]     = ContactStatus::stick;
    state.stick_points[at.point] = at.body.at_rest(at.x);
  }
} // namespace Biface
