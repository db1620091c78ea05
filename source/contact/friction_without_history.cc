// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/friction_without_history.h>

namespace Biface
{
  using namespace dealii;

  void
  FrictionWithoutHistory::start_stage(ContactState &state) const
  {
    // tractions follow from the motion alone, whatever stuck in a stage before
    for (unsigned int n = 0; n < state.statuses.size(); ++n)
      state.forget_stick_point(n);
  }


  void
  FrictionWithoutHistory::commit_step(ContactState         &state,
                                      const PointInContact &at) const
  {
    const auto   tangents = at.body.tangents(at.at_body.normal);
    Tensor<1, 3> traction;
    for (unsigned int i = 0; i < 2; ++i)
      traction += state.multipliers[at.point][1 + i] * tangents[i];
    // a stage that stands goes on from these points with the tractions of this
    // one, section 10 of doc/theory.md
    state.stick_points[at.point] =
      at.body.at_rest(Point<3>(at.x - law.elastic_slip(traction)));
  }
} // namespace Biface
