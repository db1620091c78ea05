// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/output/buckling_file.h>
#include <biface/output/csv.h>
#include <biface/output/reaction_columns.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  BucklingFile::BucklingFile(const std::vector<Stage> &stages,
                             ResultsDirectory         &directory,
                             const ShellEquations     &equations)
    : StepTable("buckling.csv",
                "step,modes,mode,stage,factor,pressure,load_factor,approach,"
                "load_work,circumferential_waves,meridional_half_waves," +
                  columns_of_forces(equations.mesh),
                0,
                directory,
                equations,
                any_buckling(stages))
  {}


  void
  BucklingFile::write(const StepReport &report, const State & /*state*/)
  {
    const Buckling &buckling = *report.buckling;
    std::string     lines;
    for (unsigned int i = 0; i < buckling.modes.size(); ++i)
      {
        const BucklingMode  &mode     = buckling.modes[i];
        const CriticalLoads &critical = buckling.loads[i];
        lines += std::to_string(report.step) + ',' +
                 std::to_string(buckling.modes.size()) + ',' +
                 std::to_string(i + 1) + ',' + report.stage;
        for (const double value : {critical.factor,
                                   critical.level.pressure,
                                   critical.level.factors[0],
                                   critical.level.travel,
                                   mode.load_work})
          lines += ',' + csv_number(value);
        lines += ',' + csv_waves(mode.waves);
        // the loads of the end of the stage but for the factors, with which
        // supports move
        Loads loads   = *report.loads;
        loads.factors = critical.level.factors;
        lines +=
          values_of_forces(equations.mesh, loads, buckling.forces[i]) + '\n';
      }
    append(lines);
  }
} // namespace Biface
