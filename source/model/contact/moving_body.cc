// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/contact/body_motion.h>
#include <biface/contact/body_parameters.h>
#include <biface/model/contact/moving_body.h>
#include <biface/model/state/load_rates.h>
#include <biface/model/state/state.h>

namespace Biface
{
  using namespace dealii;

  MovingBody::MovingBody(const BodyParameters  &other,
                         const TreadParameters &tread)
    : body(other.make().offset_by(tread.height.value_or(0)))
    , tread_height(tread.height.value_or(0))
    , other(std::make_shared<const BodyParameters>(other))
  {}


  bool
  MovingBody::is_on_ground() const
  {
    return other && other->on_ground;
  }


  RigidBody
  MovingBody::carried_by(const RigidBody &on_this, const double travel) const
  {
    // the ground itself is below the tread
    BodyMotion motion;
    motion.translation = -body.direction();
    motion.factor      = BodyMotion::travel_of_ground;
    const double moved = travel - tread_height;
    return on_this.after_motions(
      {motion},
      [&](const unsigned int) { return moved; },
      body.direction(),
      Point<3>());
  }


  RigidBody
  MovingBody::after_motions(
    const std::vector<double>                         &factors,
    const std::function<RigidBody(const RigidBody &)> &with_ground) const
  {
    Assert(other, ExcInternalError());
    const RigidBody moved = body.after_motions(
      other->motions,
      [&](const unsigned int position) { return factor_at(factors, position); },
      other->axis / other->axis.norm(),
      other->point);
    // its own motions come before that of the ground
    return is_on_ground() ? with_ground(moved) : moved;
  }
} // namespace Biface
