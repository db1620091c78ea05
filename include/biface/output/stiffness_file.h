// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_stiffness_file_h
#define biface_output_stiffness_file_h

#include <vector>

#include <biface/output/result_file.h>

namespace Biface
{
  struct Stage;


  /** stiffness.csv: a line for each step in which the ground moves in one
   * way while all other loads rest, with the secant and tangent stiffness; see
   * StepStiffness. */
  class StiffnessFile : public StepTable
  {
  public:
    /** @param stages those of the run, to see whether the file would be
     * empty. */
    StiffnessFile(const std::vector<Stage> &stages,
                  ResultsDirectory         &directory,
                  const ShellEquations     &equations);

  private:
    bool
    contains(const StepReport &report) const override;

    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
