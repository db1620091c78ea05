// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_buckling_file_h
#define biface_output_buckling_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** buckling.csv: a line for each buckling load predicted at the end of a
   * stage; see Buckling. */
  class BucklingFile : public StepTable
  {
  public:
    /** The table, which has a line per buckling load.
     * @param stages those of the run, to see whether the file would be
     * empty. */
    BucklingFile(const std::vector<Stage> &stages,
                 ResultsDirectory         &directory,
                 const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.buckling != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
