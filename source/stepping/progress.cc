// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/progress.h>

namespace Biface
{
  void
  Progress::change_stage(const Stage &before, const Stage &now)
  {
    if (!stage_begun)
      return;
    const std::unique_ptr<Control> changed = make_control(before);
    changed->restore(control);
    if (changed->change_stage(now, reached))
      predictor.reset();
    control = changed->get_memory();
  }
} // namespace Biface
