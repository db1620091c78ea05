// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_heat_file_h
#define biface_output_heat_file_h

#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** heat-NNNN.csv: a line for each ply in each strip of cells around the axle,
   * of a step in which a wheel rolls, see HeatOfPlies. */
  class HeatFile : public ResultFile
  {
  public:
    /** @param stages those of the run, to see whether a wheel rolls. */
    HeatFile(const std::vector<Stage> &stages,
             ResultsDirectory         &directory,
             const ShellEquations     &equations);

    bool
    is_wanted() const override
    {
      return wanted;
    }

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.heat.has_value();
    }

    void
    write(const StepReport &report, const State &state) override;

    const bool wanted;
  };
} // namespace Biface

#endif
