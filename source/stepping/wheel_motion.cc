// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>
#include <sstream>

#include <biface/stepping/load_level.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/wheel_motion.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The component of the velocity of a wheel in its plane. */
    double
    forward_velocity(const LoadLevel &level)
    {
      return level.ground_velocity *
             std::cos(level.slip_angle * numbers::PI / 180);
    }
  } // namespace


  Stage
  with_angular_velocity(const Stage                 &stage,
                        const LoadLevel             &start,
                        const std::optional<double> &free_radius)
  {
    // the definition of the slip ratio, solved for the angular velocity
    Stage result = stage;
    if (stage.slip_ratio)
      {
        Assert(free_radius, ExcNotInitialized());
        const LoadLevel last = stage.end(start);
        result.angular_velocity =
          (1 + *stage.slip_ratio) * forward_velocity(last) / *free_radius;
      }
    return result;
  }


  std::optional<double>
  free_radius_after(const Stage                 &ended,
                    const LoadLevel             &end,
                    const std::optional<double> &before)
  {
    // slip ratios of all later stages refer to the last free rolling
    return ended.ends_free_rolling() ? free_rolling_radius(end) : before;
  }


  double
  free_rolling_radius(const LoadLevel &level)
  {
    return forward_velocity(level) / level.angular_velocity;
  }


  double
  slip_ratio(const LoadLevel &level, const double free_radius)
  {
    // a wheel that does not go forward has none
    const double forward = forward_velocity(level);
    return forward != 0 ? level.angular_velocity * free_radius / forward - 1
                        : std::numeric_limits<double>::quiet_NaN();
  }


  std::string
  describe_wheel_motion(const LoadLevel &level, const bool rolls)
  {
    std::ostringstream text;
    if (level.wheel_turn != 0)
      text << ", wheel turned by " << level.wheel_turn;
    if (level.inclination_angle != 0)
      text << ", inclination angle " << level.inclination_angle;
    if (rolls)
      {
        text << ", angular velocity " << level.angular_velocity;
        if (level.ground_velocity != 0)
          text << ", ground velocity " << level.ground_velocity;
        if (level.slip_angle != 0)
          text << ", slip angle " << level.slip_angle;
      }
    return text.str();
  }
} // namespace Biface
