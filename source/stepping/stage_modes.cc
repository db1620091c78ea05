// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/mesh/rigid_motions.h>
#include <biface/stepping/stage_modes.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  void
  StageModes::end_stage(const StageRun &run, StepReport &report)
  {
    if (run.stage.n_modes == 0)
      return;
    auto modes = std::make_shared<const VibrationModes>(
      modal_analysis.compute(run.state,
                             *report.loads,
                             run.stage.n_modes,
                             with_left(report.instant.stage)));
    if (!modes->success)
      {
        out << "  Warning: the modes of " << run.stage.name
            << " were not found: " << modes->message << std::endl;
        return;
      }
    if (!modes->neutral_motions.empty())
      out << "  nothing resists " << in_words(modes->neutral_motions)
          << ": frequency 0" << std::endl;
    out << "  frequencies:";
    for (const VibrationMode &mode : modes->modes)
      out << ' ' << mode.frequency();
    out << std::endl;
    if (modes->with_air)
      {
        out << "  of the air:";
        for (const VibrationMode &mode : modes->modes)
          if (mode.part_of_air > 0.5)
            out << ' ' << mode.frequency();
        out << std::endl;
      }
    report.modes = modes;
  }
} // namespace Biface
