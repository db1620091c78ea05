// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_modes_file_h
#define biface_output_modes_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** modes.csv: a line for each mode of vibration at the end of a stage, with
   * its frequency; see VibrationMode. */
  class ModesFile : public StepTable
  {
  public:
    /** @param stages those of the run, to see whether the file would be
     * empty. */
    ModesFile(const std::vector<Stage> &stages,
              ResultsDirectory         &directory,
              const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.modes != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
