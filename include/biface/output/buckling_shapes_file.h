// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_buckling_shapes_file_h
#define biface_output_buckling_shapes_file_h

#include <string>
#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  struct Stage;


  /** buckling-NNNN-MMM.csv: the normal displacements of the shapes in which the
   * shell buckles, as tables for Imperfection. The largest is 1. */
  class BucklingShapesFile : public ResultFile
  {
  public:
    /** @param stages those of the run, to see whether there are any shapes. */
    BucklingShapesFile(const std::vector<Stage> &stages,
                       ResultsDirectory         &directory,
                       const ShellEquations     &equations);

    std::string
    names_of_files() const override
    {
      return "buckling-([0-9]{4,})-[0-9]{3,}\\.csv";
    }

    bool
    is_wanted() const override
    {
      return wanted;
    }

  private:
    bool
    contains(const StepReport &report) const override
    {
      return report.buckling != nullptr;
    }

    void
    write(const StepReport &report, const State &state) override;

    const bool wanted;
  };
} // namespace Biface

#endif
