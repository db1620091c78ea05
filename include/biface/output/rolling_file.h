// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_rolling_file_h
#define biface_output_rolling_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** rolling.csv: a line for each step in which a wheel rolls over the ground,
   * see RollingSummary. */
  class RollingFile : public StepTable
  {
  public:
    /** @param stages those of the run, to see whether the file would be
     * empty. */
    RollingFile(const std::vector<Stage> &stages,
                ResultsDirectory         &directory,
                const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.rolling.has_value();
    }

    void
    write(const StepReport &report, const State &state) override;

    /** Whether a stage has 'Transient rolling'. */
    const bool has_time;
  };
} // namespace Biface

#endif
