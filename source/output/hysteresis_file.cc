// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <string>

#include <biface/contact/rolling.h>
#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/output/csv.h>
#include <biface/output/hysteresis_file.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  HysteresisFile::HysteresisFile(const std::vector<Stage> &stages,
                                 ResultsDirectory         &directory,
                                 const ShellEquations     &equations)
    : StepTable("hysteresis.csv",
                "step,stage,ply,material,loss_factor,energy,power,"
                "first_harmonics",
                equations.mesh.get_layup().get_plies().size(),
                directory,
                equations,
                any_rolling(stages) && equations.mesh.get_layup().has_loss())
  {}


  void
  HysteresisFile::write(const StepReport &report, const State & /*state*/)
  {
    const std::vector<PlyDescription> &plies =
      equations.mesh.get_layup().get_plies();
    const double angular_velocity = report.loads->rolling->angular_velocity;
    std::string  lines;
    for (unsigned int p = 0; p < plies.size(); ++p)
      {
        const Hysteresis::OfPly &of_ply = report.rolling->hysteresis->plies[p];
        lines += std::to_string(report.step) + ',' + report.stage + ',' +
                 std::to_string(p + 1) + ',' + plies[p].material.name;
        for (const double value :
             {plies[p].material.loss_factor,
              of_ply.energy,
              Hysteresis::power(of_ply.energy, angular_velocity),
              of_ply.of_first_harmonics})
          lines += ',' + csv_number(value);
        lines += '\n';
      }
    append(lines);
  }
} // namespace Biface
