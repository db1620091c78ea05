// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/program/parameters.h>

namespace Biface
{
  void
  Parameters::check_damping() const
  {
    const std::vector<bool> rolls = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage &stage = stages[i];
        if (stage.damping == 0)
          continue;
        const std::string section = "Stage " + std::to_string(i + 1);
        const auto refuse = [&](const bool wrong, const std::string &why) {
          if (wrong)
            throw InputError(section + "/Damping",
                             number_to_string(stage.damping),
                             "it must be 0 " + why);
        };
        refuse(stage.control == ControlKind::displacement ||
                 stage.control == ControlKind::arc_length,
               "with 'Control = " + stage.control_name() +
                 "', which passes unstable equilibria without it");
        refuse(rolls[i], "in a stage in which the wheel rolls");
        refuse(stage.locates_critical_points(),
               "with 'Critical points = " +
                 critical_points_names()[static_cast<unsigned int>(
                   stage.critical_points)] +
                 "'");
        const std::string why =
          ": with damping, the stage does not end in equilibrium";
        refuse(stage.n_modes > 0, "with 'Modes'" + why);
        refuse(stage.n_buckling > 0, "with 'Buckling'" + why);
        refuse(!sensitivities.entries.empty(),
               "with 'Sensitivities/Entries': derivatives do not follow a "
               "shell that snaps");
      }
  }
} // namespace Biface
