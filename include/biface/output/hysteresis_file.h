// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_hysteresis_file_h
#define biface_output_hysteresis_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** hysteresis.csv: a line for each ply in each step in which a wheel rolls,
   * see Hysteresis. */
  class HysteresisFile : public StepTable
  {
  public:
    /** @param stages those of the run, to see whether the file would be
     * empty. */
    HysteresisFile(const std::vector<Stage> &stages,
                   ResultsDirectory         &directory,
                   const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.rolling && report.rolling->hysteresis;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
