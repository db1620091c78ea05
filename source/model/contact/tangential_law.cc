// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/tangential_law.h>

namespace Biface
{
  using namespace dealii;

  void
  TangentialLaw::start_stage(State &state) const
  {
    for (Grip &grip : state.grips)
      if (grip == Grip::glued)
        grip = Grip::stick;
  }


  void
  TangentialLaw::commit_step(State               &state,
                             const Loads         &loads,
                             const NodeInContact &at) const
  {
    state.grips[at.node]        = Grip::stick;
    state.stick_points[at.node] = loads.foundation->at_rest(at.x);
  }


  void
  forget_stick_point(State &state, const unsigned int node)
  {
    state.grips[node]        = Grip::none;
    state.stick_points[node] = Point<3>();
  }
} // namespace Biface
