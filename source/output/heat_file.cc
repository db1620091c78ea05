// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>

#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/csv.h>
#include <biface/output/heat_file.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  HeatFile::HeatFile(const std::vector<Stage> &stages,
                     ResultsDirectory         &directory,
                     const ShellEquations     &equations)
    : ResultFile("heat-*.csv", directory, equations)
    , wanted(any_rolling(stages) && equations.mesh.get_layup().has_loss())
  {}


  void
  HeatFile::write(const StepReport &report, const State & /*state*/)
  {
    const ShellMesh   &mesh  = equations.mesh;
    const HeatOfPlies &heat  = *report.heat;
    const auto        &plies = mesh.get_layup().get_plies();
    const auto         line  = [&](const unsigned int i) {
      return csv_number(mesh.grid.lines[0][i] /
                        mesh.get_surface().coordinate_unit(0));
    };
    std::string text =
      "alpha_1_begin,alpha_1_end,ply,material,source,temperature\n";
    for (unsigned int i = 0; i < mesh.n_strips(); ++i)
      for (const Ply &ply : mesh.strips[i].laminate.get_plies())
        text += line(i) + ',' + line(i + 1) + ',' +
                std::to_string(ply.number + 1) + ',' +
                plies[ply.number].material.name + ',' +
                csv_number(heat.source(i, ply.number)) + ',' +
                (heat.temperature.empty()
                   ? std::string()
                   : csv_number(heat.temperature(i, ply.number))) +
                '\n';
    write_text(path(report.step), text, false, communicator);
  }
} // namespace Biface
