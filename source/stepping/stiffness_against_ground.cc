// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/stiffness_against_ground.h>

namespace Biface
{
  using namespace dealii;

  std::optional<StiffnessAgainstGround>
  stiffness_against_ground(const GroundReaction &from,
                           const GroundReaction &to,
                           const Tensor<1, 3>   &outward,
                           const Point<3>       &center)
  {
    using Motion = StiffnessAgainstGround::Motion;

    // a stiffness is a force by a motion of the ground alone, in axes that do
    // not turn
    if (from.level.angular_velocity != to.level.angular_velocity ||
        from.level.ground_velocity != to.level.ground_velocity ||
        from.level.slip_angle != to.level.slip_angle ||
        from.level.wheel_turn != 0 || to.level.wheel_turn != 0 ||
        from.level.inclination_angle != 0 || to.level.inclination_angle != 0)
      return {};

    const double       approach = to.level.travel - from.level.travel;
    const Tensor<1, 3> slide    = to.level.slide - from.level.slide;
    const double       turn     = to.level.turn - from.level.turn;
    const unsigned int n_motions =
      (approach != 0) + (slide.norm() > 0) + (turn != 0);
    // of several motions, no part of the force belongs to one alone
    if (n_motions != 1)
      return {};

    StiffnessAgainstGround result;
    if (approach != 0)
      {
        result.motion    = Motion::approach;
        result.direction = -outward;
        result.amount    = approach;
      }
    else if (turn != 0)
      {
        result.motion    = Motion::turn;
        result.direction = outward;
        result.amount    = turn;
      }
    else
      {
        result.motion    = Motion::slide;
        result.amount    = slide.norm();
        result.direction = slide / result.amount;
      }
    const Tensor<1, 3> force  = to.force - from.force;
    const Tensor<1, 3> moment = to.moment - from.moment;
    result.force              = force / result.amount;
    // moments are given about the origin, which is no point of the footprint
    result.moment =
      (moment - cross_product_3d(Tensor<1, 3>(center), force)) / result.amount;
    return result;
  }
} // namespace Biface
