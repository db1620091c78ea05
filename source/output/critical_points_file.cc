// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/equations/shell_equations.h>
#include <biface/output/critical_points_file.h>
#include <biface/output/csv.h>
#include <biface/output/reaction_columns.h>
#include <biface/stepping/critical_point.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  CriticalPointsFile::CriticalPointsFile(const std::vector<Stage> &stages,
                                         ResultsDirectory         &directory,
                                         const ShellEquations     &equations)
    : StepTable(
        "critical_points.csv",
        "step,stage,kind,located,negative_pivots_before,"
        "negative_pivots,factor,pressure,load_factor,approach,load_work,"
        "circumferential_waves,meridional_half_waves," +
          columns_of_forces(equations.mesh),
        1,
        directory,
        equations,
        any_located_points(stages))
  {}


  void
  CriticalPointsFile::write(const StepReport &report, const State & /*state*/)
  {
    const CriticalPoint &point = *report.critical_point;
    std::string line = std::to_string(report.step) + ',' + report.stage + ',' +
                       point.kind() + ',' + (point.located ? "true" : "false") +
                       ',' + std::to_string(point.n_negative_before) + ',' +
                       std::to_string(point.n_negative_after);
    for (const double value : {point.loads.factor,
                               point.loads.level.pressure,
                               point.loads.level.factors[0],
                               point.loads.level.travel,
                               point.mode.load_work})
      line += ',' + csv_number(value);
    append(
      line + ',' + csv_waves(point.mode.waves) +
      values_of_forces(equations.mesh, *report.loads, report.forces_of_bodies) +
      '\n');
  }
} // namespace Biface
