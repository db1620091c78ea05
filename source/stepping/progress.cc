// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include <biface/stepping/progress.h>

namespace Biface
{
  using namespace dealii;

  void
  StepSize::succeeded(const double growth, const double greatest)
  {
    value  = std::min(growth * value, greatest);
    n_cuts = (n_cuts > 0 ? n_cuts - 1 : 0);
  }


  bool
  StepSize::failed(const unsigned int max_cuts, ConditionalOStream &out)
  {
    if (n_cuts >= max_cuts)
      return false;
    ++n_cuts;
    value /= 2;
    out << "  the step is cut in half" << std::endl;
    return true;
  }


  bool
  Progress::at_end_of(const Stage &stage) const
  {
    return (stage.control == Stage::Control::displacement ? value_fraction
                                                          : fraction) >= 1;
  }


  bool
  Progress::at_end_of(const std::vector<Stage> &stages) const
  {
    return stage_begun && stage + 1 == stages.size() &&
           at_end_of(stages[stage]);
  }


  namespace
  {
    /** A load on its way. */
    struct Way
    {
      double begin, now, end;
    };


    /** The part of their ways that all loads have gone, if it is the same for
     * all. */
    std::optional<double>
    common_part(const std::vector<Way> &ways)
    {
      std::optional<double> part;
      for (const Way &way : ways)
        if (!part && way.end != way.begin)
          part = (way.now - way.begin) / (way.end - way.begin);
      for (const Way &way : ways)
        {
          const double done     = way.now - way.begin;
          const double expected = part.value_or(0) * (way.end - way.begin);
          if (std::abs(done - expected) >
              1e-9 * std::max(std::abs(done), std::abs(expected)))
            return {};
        }
      return part;
    }
  } // namespace


  void
  Progress::change_stage(const Stage &before, const Stage &now)
  {
    const bool same_way =
      before.pressure == now.pressure && before.factor == now.factor &&
      before.travel == now.travel && before.force == now.force &&
      before.control_value == now.control_value;
    if (same_way && before.n_steps == now.n_steps &&
        before.adaptive == now.adaptive)
      return;

    const bool by_arc          = (now.control == Stage::Control::arc_length);
    const bool by_force        = (now.control == Stage::Control::force);
    const bool by_displacement = (now.control == Stage::Control::displacement);
    if (!same_way)
      {
        // where the force or the displacement is
        const double value =
          begin_value +
          (by_force ? fraction * (before.force - begin_value)
                    : value_fraction * (before.control_value - begin_value));
        std::vector<Way> ways{{begin.pressure, reached.pressure, now.pressure},
                              {begin.factor, reached.factor, now.factor}};
        if (by_force)
          ways.push_back({begin_value, value, now.force});
        else
          ways.push_back({begin.travel, reached.travel, now.travel});
        const std::optional<double> part = common_part(ways);
        const std::optional<double> value_part =
          (by_displacement
             ? common_part({{begin_value, value, now.control_value}})
             : std::optional<double>(0));
        const auto within = [](const double x) { return 0 <= x && x <= 1; };
        if (part && value_part && within(*value_part) &&
            (by_arc || by_displacement || within(*part)))
          {
            fraction       = *part;
            value_fraction = *value_part;
          }
        else
          {
            begin          = reached;
            begin_value    = value;
            fraction       = 0;
            value_fraction = 0;
          }
        predictor.reset();
      }
    // an arc length that was found stays
    if (!by_arc || first_arc_length == 0)
      size = StepSize(1. / now.n_steps);
  }
} // namespace Biface
