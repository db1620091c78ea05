// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_response_file_h
#define biface_output_response_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** response.csv: transfer functions, a line for each excitation, frequency
   * and output; see FrequencyResponse. */
  class ResponseFile : public StepTable
  {
  public:
    /** @param stages those of the run, to see whether the file would be
     * empty. */
    ResponseFile(const std::vector<Stage> &stages,
                 ResultsDirectory         &directory,
                 const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.response != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
