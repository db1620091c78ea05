// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>
#include <string>

#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/output/csv.h>
#include <biface/output/rolling_file.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    bool
    any_transient_rolling(const std::vector<Stage> &stages)
    {
      return std::any_of(stages.begin(), stages.end(), [](const Stage &stage) {
        return stage.transient_rolling;
      });
    }
  } // namespace


  RollingFile::RollingFile(const std::vector<Stage> &stages,
                           ResultsDirectory         &directory,
                           const ShellEquations     &equations)
    : StepTable(
        "rolling.csv",
        "step,stage,angular_velocity,ground_velocity,slip_angle,"
        "inclination_angle,rolling_radius,slip_ratio,F_x,F_y,F_z,M_x,M_y,M_z,axle_moment,axle_power,"
        "ground_power,friction_power,normal_power,mismatch,sliding_power,release_power" +
          std::string(equations.mesh.get_layup().has_loss()
                        ? ",hysteresis_power,rolling_resistance"
                        : "") +
          (any_transient_rolling(stages) ? ",time" : ""),
        1,
        directory,
        equations,
        any_rolling(stages))
    , has_time(any_transient_rolling(stages))
  {}


  void
  RollingFile::write(const StepReport &report, const State & /*state*/)
  {
    const RollingSummary &rolling = *report.rolling;
    std::vector<double>   values{
      report.level.angular_velocity,
      report.level.ground_velocity,
      report.level.slip_angle,
      report.level.inclination_angle,
      rolling.rolling_radius,
      report.slip_ratio.value_or(std::numeric_limits<double>::quiet_NaN())};
    for (const Tensor<1, 3> &vector : {rolling.force, rolling.moment})
      for (unsigned int i = 0; i < 3; ++i)
        values.push_back(vector[i]);
    for (const double value : {rolling.axle_moment,
                               rolling.axle_power,
                               rolling.ground_power,
                               rolling.friction_power,
                               rolling.normal_power,
                               rolling.mismatch,
                               rolling.sliding_power,
                               rolling.release_power})
      values.push_back(value);
    if (equations.mesh.get_layup().has_loss())
      {
        values.push_back(rolling.hysteresis_power);
        values.push_back(rolling.rolling_resistance);
      }
    if (has_time)
      values.push_back(report.level.time);
    std::string line = std::to_string(report.step) + ',' + report.stage;
    for (const double value : values)
      line += ',' + csv_number(value);
    append(line + '\n');
  }
} // namespace Biface
