// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/output/csv.h>
#include <biface/output/modes_file.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  ModesFile::ModesFile(const std::vector<Stage> &stages,
                       ResultsDirectory         &directory,
                       const ShellEquations     &equations)
    : StepTable("modes.csv",
                "step,modes,mode,stage,frequency,growth_rate,generalized_mass,"
                "participation_x,participation_y,participation_z,"
                "effective_mass_x,effective_mass_y,effective_mass_z,"
                "total_mass,circumferential_waves,meridional_half_waves,travel,"
                "part_of_air",
                0,
                directory,
                equations,
                any_modes(stages))
  {}


  void
  ModesFile::write(const StepReport &report, const State & /*state*/)
  {
    const std::vector<VibrationMode> &modes = report.modes->modes;
    std::string                       lines;
    for (unsigned int i = 0; i < modes.size(); ++i)
      {
        const VibrationMode &mode = modes[i];
        lines += std::to_string(report.step) + ',' +
                 std::to_string(modes.size()) + ',' + std::to_string(i + 1) +
                 ',' + report.stage + ',' + csv_number(mode.frequency()) + ',' +
                 csv_number(mode.growth_rate()) + ',' + csv_number(mode.mass);
        for (unsigned int d = 0; d < 3; ++d)
          lines += ',' + csv_number(mode.participation[d]);
        for (unsigned int d = 0; d < 3; ++d)
          lines += ',' + csv_number(mode.effective_mass(d));
        lines += ',' + csv_number(report.modes->total_mass) + ',' +
                 csv_waves(mode.waves) + ',' +
                 (mode.waves ? csv_number(mode.waves->travel) : "nan") + ',' +
                 csv_number(mode.part_of_air) + '\n';
      }
    append(lines);
  }
} // namespace Biface
