// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/output/csv.h>
#include <biface/output/sensitivities_file.h>
#include <biface/stepping/sensitivity_table.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  SensitivitiesFile::SensitivitiesFile(const unsigned int    n_pairs,
                                       ResultsDirectory     &directory,
                                       const ShellEquations &equations)
    : StepTable("sensitivities.csv",
                "step,stage,entry,entry_value,output,output_value,derivative,"
                "logarithmic_derivative",
                n_pairs,
                directory,
                equations,
                n_pairs > 0)
  {}


  void
  SensitivitiesFile::write(const StepReport &report, const State & /*state*/)
  {
    const SensitivityTable &table = *report.sensitivities;
    std::string             lines;
    for (unsigned int e = 0; e < table.entries.size(); ++e)
      for (unsigned int o = 0; o < table.outputs.size(); ++o)
        lines += std::to_string(report.step) + ',' + report.stage + ',' +
                 table.entries[e].name + ',' +
                 csv_number(table.entries[e].value) + ',' +
                 table.outputs[o].name + ',' +
                 csv_number(table.outputs[o].value) + ',' +
                 csv_number(table.derivatives[e][o]) + ',' +
                 csv_number(table.logarithmic(e, o)) + '\n';
    append(lines);
  }
} // namespace Biface
