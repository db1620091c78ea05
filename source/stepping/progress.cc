// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/wheel_motion.h>

namespace Biface
{
  Stage
  Progress::complete(const Stage &given) const
  {
    // a part of a stage depends on where it starts: the angular velocity of a
    // slip ratio, and the time at its end
    const LoadLevel &start = start_of_stage();
    Stage result = with_angular_velocity(given, start, free_rolling_radius);
    if (given.duration > 0)
      result.time = start.time + given.duration;
    return result;
  }


  void
  Progress::end_stage(const Stage &ended)
  {
    free_rolling_radius =
      free_radius_after(ended, reached, free_rolling_radius);
  }


  void
  Progress::rearrange_factors(const std::vector<unsigned int> &positions)
  {
    for (std::vector<double> *factors : {&reached.factors,
                                         &control.start.factors,
                                         &factors_of_shape,
                                         &first_reactions.level.factors})
      *factors = rearranged(*factors, positions);
    if (reactions)
      reactions->level.factors =
        rearranged(reactions->level.factors, positions);
  }


  void
  Progress::change_stage(const Stage &before, const Stage &now)
  {
    // a stage that has not begun is made from the changed file anyway
    if (!stage_begun)
      return;
    const std::unique_ptr<Control> changed = make_control(complete(before));
    changed->restore(control);
    LoadLevel level = reached;
    // the pressure of a sealed gas is on no path
    if (before.sealed)
      level.pressure = control.start.pressure;
    if (changed->change_stage(complete(now), level))
      predictor.reset();
    control = changed->get_memory();
  }
} // namespace Biface
