// SPDX-License-Identifier: LGPL-2.1-or-later

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
