// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <string>

#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/stage_sequence.h>

namespace Biface
{
  using namespace dealii;

  std::optional<unsigned int>
  stage_before(const std::vector<Stage> &stages, const unsigned int position)
  {
    if (position == 0)
      return {};
    return stages[position].start_from.value_or(position) - 1;
  }


  bool
  is_branched_from(const std::vector<Stage> &stages,
                   const unsigned int        position)
  {
    // the next stage goes on from the state at hand and needs no copy
    for (unsigned int later = position + 2; later < stages.size(); ++later)
      if (stage_before(stages, later) == position)
        return true;
    return false;
  }


  std::optional<unsigned int>
  continued_stage(const std::vector<Stage> &stages, const unsigned int position)
  {
    return stages[position].from_prestress ? std::nullopt
                                           : stage_before(stages, position);
  }


  std::vector<std::optional<unsigned int>>
  continued_stages(const std::vector<Stage> &stages)
  {
    std::vector<std::optional<unsigned int>> result;
    for (unsigned int i = 0; i < stages.size(); ++i)
      result.push_back(continued_stage(stages, i));
    return result;
  }


  namespace
  {
    template <typename Predicate>
    bool
    any(const std::vector<Stage> &stages, const Predicate &predicate)
    {
      return std::any_of(stages.begin(), stages.end(), predicate);
    }
  } // namespace


  bool
  any_modes(const std::vector<Stage> &stages)
  {
    return any(stages, [](const Stage &stage) { return stage.n_modes > 0; });
  }


  bool
  any_buckling(const std::vector<Stage> &stages)
  {
    return any(stages, [](const Stage &stage) { return stage.n_buckling > 0; });
  }


  bool
  any_response(const std::vector<Stage> &stages)
  {
    return any(stages, [](const Stage &stage) { return stage.vibrates(); });
  }


  bool
  any_located_points(const std::vector<Stage> &stages)
  {
    return any(stages, [](const Stage &stage) {
      return stage.locates_critical_points();
    });
  }


  bool
  any_motion_of_ground(const std::vector<Stage> &stages)
  {
    return any(stages, [](const Stage &stage) { return stage.moves_ground(); });
  }


  bool
  any_rolling(const std::vector<Stage> &stages)
  {
    return any(stages, [](const Stage &stage) { return stage.contact; }) &&
           any(stages,
               [](const Stage &stage) { return stage.rolls(LoadLevel()); });
  }


  namespace
  {
    unsigned int
    fewest(const std::vector<Stage> &stages, unsigned int Stage::*const number)
    {
      unsigned int result = numbers::invalid_unsigned_int;
      for (const Stage &stage : stages)
        result = std::min(result, stage.*number);
      return result;
    }
  } // namespace


  unsigned int
  fewest_modes(const std::vector<Stage> &stages)
  {
    return fewest(stages, &Stage::n_modes);
  }


  unsigned int
  fewest_buckling_loads(const std::vector<Stage> &stages)
  {
    return fewest(stages, &Stage::n_buckling);
  }


  void
  check_stages(const std::vector<Stage> &stages)
  {
    std::vector<Control::KnownStart> ends;
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage      &stage   = stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        const auto        before  = stage_before(stages, i);
        stage.check(section);
        // what a stage computes is unknown to all that start from its end
        Control::KnownStart start =
          (before ? ends[*before] : Control::KnownStart::undeformed());
        if (stage.from_prestress)
          {
            for_each_motion([](auto &known, const auto &zero) { known = zero; },
                            start,
                            LoadLevel());
            start.is_undeformed = true;
          }
        const auto control = make_control(stage);
        control->check(section, start);
        ends.push_back(control->known_end(start));
      }
  }
} // namespace Biface
