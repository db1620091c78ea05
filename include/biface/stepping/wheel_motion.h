// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_wheel_motion_h
#define biface_stepping_wheel_motion_h

#include <optional>
#include <string>

namespace Biface
{
  struct LoadLevel;
  struct Stage;


  /** The rolling radius in free rolling, @f$V\cos\alpha/\Omega@f$. */
  double
  free_rolling_radius(const LoadLevel &level);

  /** The slip ratio of ISO 8855, @f$(\Omega R-V\cos\alpha)/(V\cos\alpha)@f$;
   * not a number if the wheel does not move forward.
   * @param free_radius R, see free_rolling_radius(). */
  double
  slip_ratio(const LoadLevel &level, const double free_radius);

  /** A stage with the angular velocity that belongs to its slip ratio S, if one
   * is given, @f$\Omega=(1+S)\,V\cos\alpha/R@f$ with the ground velocity V and
   * the slip angle @f$\alpha@f$ at its end.
   * @param start the loads at its start.
   * @param free_radius R, see free_rolling_radius(). */
  Stage
  with_angular_velocity(const Stage                 &stage,
                        const LoadLevel             &start,
                        const std::optional<double> &free_radius);

  /** The free rolling radius after a stage: that at its end if it ends in free
   * rolling, otherwise @p before. */
  std::optional<double>
  free_radius_after(const Stage                 &ended,
                    const LoadLevel             &end,
                    const std::optional<double> &before);

  /** The motion of a wheel as the log announces it: the angle by which it has
   * turned on the ground and, if it rolls, its velocities. */
  std::string
  describe_wheel_motion(const LoadLevel &level, const bool rolls);
} // namespace Biface

#endif
