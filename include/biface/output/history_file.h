// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_history_file_h
#define biface_output_history_file_h

#include <biface/output/result_file.h>

namespace Biface
{
  /** history.csv: a line per step with its loads, its contact zone and
   * its strain energy. */
  class HistoryFile : public StepTable
  {
  public:
    HistoryFile(ResultsDirectory &directory, const ShellEquations &equations);

  private:
    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
