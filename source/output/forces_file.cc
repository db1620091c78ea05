// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/output/csv.h>
#include <biface/output/forces_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  void
  ForcesFile::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Moment center",
                      moment_center,
                      "The point to which the moments in forces.csv refer: "
                      "coordinates x, y, z.",
                      // it is part of what moments and their derivatives mean
                      Unit("length") | EntryKind::problem |
                        RestartChange::always);
  }


  ForcesFile::ForcesFile(const Parameters     &parameters,
                         ResultsDirectory     &directory,
                         const ShellEquations &equations)
    : StepTable("forces.csv",
                "step,stage,body,F_x,F_y,F_z,M_x,M_y,M_z",
                bodies_on_shell(equations).size(),
                directory,
                equations)
    , parameters(parameters)
  {
    check_finite("Output/Moment center", parameters.moment_center);
  }


  void
  ForcesFile::write(const StepReport &report, const State &)
  {
    std::string lines;
    for (const ForceOnShell &item : report.forces_of_bodies)
      {
        lines +=
          std::to_string(report.step) + ',' + report.stage + ',' + item.body;
        for (const auto &vector :
             {item.force, item.moment_about(parameters.moment_center)})
          for (unsigned int i = 0; i < 3; ++i)
            lines += ',' + csv_number(vector[i]);
        lines += '\n';
      }
    append(lines);
  }
} // namespace Biface
