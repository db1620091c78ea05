// SPDX-License-Identifier: LGPL-2.1-or-later

#include <sstream>

#include <biface/output/csv.h>
#include <biface/output/history_file.h>

namespace Biface
{
  HistoryFile::HistoryFile(ResultsDirectory     &directory,
                           const ShellEquations &equations)
    : StepTable("history.csv",
                "step,stage,approach,force,contact_nodes,contact_area,"
                "max_pressure,iterations,seconds,pressure,load_factor,"
                "strain_energy",
                1,
                directory,
                equations)
  {}


  void
  HistoryFile::write(const StepReport &report, const State &state)
  {
    std::ostringstream line;
    line << report.step << ',' << report.stage << ','
         << csv_number(report.approach) << ','
         << csv_number(report.contact.force) << ',' << report.contact.n_nodes
         << ',' << csv_number(report.contact.area) << ','
         << csv_number(report.contact.max_pressure) << ',' << report.iterations
         << ',' << csv_number(report.seconds) << ','
         << csv_number(report.loads.pressure) << ','
         << csv_number(report.loads.factor) << ','
         << csv_number(equations.internal_forces().strain_energy(state))
         << '\n';
    append(line.str());
  }
} // namespace Biface
