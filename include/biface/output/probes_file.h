// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_probes_file_h
#define biface_output_probes_file_h

#include <biface/output/result_file.h>

namespace Biface
{
  /** probes.csv: displacements of both faces and of the middle surface at the
   * named points, and their velocities if a stage goes through time. */
  class ProbesFile : public StepTable
  {
  public:
    ProbesFile(ResultsDirectory &directory, const ShellEquations &equations);

    /** Whether a point is named. */
    bool
    is_wanted() const override;

  private:
    void
    write(const StepReport &report, const State &state) override;

    const bool with_velocities;
  };
} // namespace Biface

#endif
