// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/stepping/controls/load_control.h>

namespace Biface
{
  Control::Trial
  LoadControl::propose(const Equilibrium & /*from*/) const
  {
    Trial trial;
    trial.level = [this](const LoadParameters &mu) { return level_at(mu[0]); };
    trial.mu    = {next()};
    trial.size  = trial.mu[0] - fraction;
    return trial;
  }


  void
  LoadControl::change_path(const Stage &now, const LoadLevel &reached)
  {
    go_on_from(common_part(progressions_of_loads(reached, now.end(start))),
               reached);
  }
} // namespace Biface
