// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_critical_points_file_h
#define biface_output_critical_points_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** critical_points.csv: a line for each step that passed or ended at a
   * critical point; see CriticalPoint. */
  class CriticalPointsFile : public StepTable
  {
  public:
    /** @param stages those of the run; the file is written if one of them asks
     * for more than a report. */
    CriticalPointsFile(const std::vector<Stage> &stages,
                       ResultsDirectory         &directory,
                       const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.critical_point != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
