// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_sensitivities_file_h
#define biface_output_sensitivities_file_h


#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** sensitivities.csv: at the end of a stage, a line for each pair of an entry
   * and an output with the derivative, see SensitivityTable. */
  class SensitivitiesFile : public StepTable
  {
  public:
    /** @param n_pairs of entries and outputs. */
    SensitivitiesFile(const unsigned int    n_pairs,
                      ResultsDirectory     &directory,
                      const ShellEquations &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.sensitivities != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
