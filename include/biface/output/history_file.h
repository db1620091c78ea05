// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_history_file_h
#define biface_output_history_file_h

#include <optional>
#include <string>
#include <vector>

#include <biface/model/cavity.h>
#include <biface/output/failure_maxima.h>
#include <biface/output/result_file.h>

namespace Biface
{
  /** The names of the columns of history.csv.
   * @param with_volume whether that of the cavity is one of them. */
  std::vector<std::string>
  history_columns(const FailureCriteria &criteria,
                  const ShellMesh       &mesh,
                  const bool             with_volume);


  /** The numbers of a line of history.csv after the step and the name of the
   * stage; empty fields are not set. Must be called on all ranks.
   * @param cavity null if its volume is not of interest.
   * @param failure_maxima see find_failure_maxima(). */
  std::vector<std::optional<double>>
  history_values(const StepReport                  &report,
                 const State                       &state,
                 const ShellEquations              &equations,
                 const Cavity                      *cavity,
                 const std::vector<FailureMaximum> &failure_maxima);


  /** history.csv: a line per step with its loads, its contact zone, its strain
   * energy, and the maxima of the requested failure indices. */
  class HistoryFile : public StepTable
  {
  public:
    /** @param cavity null if its volume is not of interest. */
    HistoryFile(const FailureCriteria &criteria,
                const Cavity          *cavity,
                ResultsDirectory      &directory,
                const ShellEquations  &equations);

    /** The names of the columns, separated by commas. */
    static std::string
    header(const FailureCriteria &criteria,
           const ShellMesh       &mesh,
           const bool             with_volume);

    std::vector<std::string>
    warnings() const override;

    /** Those of the last step written. */
    const std::vector<FailureMaximum> &
    get_failure_maxima() const
    {
      return failure_maxima;
    }

  private:
    void
    write(const StepReport &report, const State &state) override;

    const FailureCriteria       criteria;
    const Cavity               *cavity;
    std::vector<FailureMaximum> failure_maxima;
  };
} // namespace Biface

#endif
