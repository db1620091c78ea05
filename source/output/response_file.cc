// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/output/csv.h>
#include <biface/output/response_file.h>
#include <biface/solver/harmonic_response.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  ResponseFile::ResponseFile(const std::vector<Stage> &stages,
                             ResultsDirectory         &directory,
                             const ShellEquations     &equations)
    : StepTable("response.csv",
                "step,lines,stage,excitation,frequency,output,kind,"
                "x_real,x_imaginary,y_real,y_imaginary,z_real,z_imaginary",
                0,
                directory,
                equations,
                any_response(stages))
  {}


  void
  ResponseFile::write(const StepReport &report, const State & /*state*/)
  {
    const FrequencyResponse &response = *report.response;
    const std::string        start =
      std::to_string(report.step) + ',' +
      std::to_string(response.frequencies.size() * response.excitations.size() *
                     response.outputs.size()) +
      ',' + report.stage + ',';
    std::string lines;
    for (unsigned int e = 0; e < response.excitations.size(); ++e)
      for (unsigned int k = 0; k < response.outputs.size(); ++k)
        for (unsigned int f = 0; f < response.frequencies.size(); ++f)
          {
            lines += start + response.excitations[e] + ',' +
                     csv_number(response.frequencies[f]) + ',' +
                     response.outputs[k].name + ',' + response.outputs[k].kind;
            for (const std::complex<double> &value : response.values[f][e][k])
              lines +=
                ',' + csv_number(value.real()) + ',' + csv_number(value.imag());
            lines += '\n';
          }
    append(lines);
  }
} // namespace Biface
