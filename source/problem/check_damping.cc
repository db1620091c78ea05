// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>

namespace Biface
{
  namespace
  {
    /** Check that a stage does not need an equilibrium at its start. */
    void
    check_start_from_damped(const Stage &stage, const std::string &section)
    {
      const auto refuse = [&](const bool         wrong,
                              const std::string &entry,
                              const std::string &value,
                              const std::string &allowed) {
        if (wrong)
          throw InputError(section + "/" + entry,
                           value,
                           "it must be " + allowed +
                             " directly after a stage with 'Damping' or "
                             "'Inertia', which does not end in equilibrium");
      };
      refuse(stage.from_prestress, "Start from prestress", "true", "'false'");
      refuse(stage.n_buckling > 0,
             "Buckling",
             std::to_string(stage.n_buckling),
             "0");
      refuse(stage.locates_critical_points(),
             "Critical points",
             stage.critical_points_name(),
             "'report' or 'ignore'");
    }
  } // namespace


  void
  Parameters::check_damping() const
  {
    const std::vector<bool> rolls = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage      &stage   = stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        // forces of dashpots remain at the end of the stage before, and vanish
        // only in the first step of this one
        if (const auto before = stage_before(stages, i);
            before && (stages[*before].damping > 0 || stages[*before].inertia))
          check_start_from_damped(stage, section);
        if (stage.damping == 0)
          continue;
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
               "with 'Critical points = " + stage.critical_points_name() + "'");
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
