// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_history_file_h
#define biface_output_history_file_h

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/forces/cavity.h>
#include <biface/output/failure_maxima.h>
#include <biface/output/requested_criteria.h>
#include <biface/output/result_file.h>

namespace Biface
{
  /** Columns of history.csv whose values are computed together. */
  struct HistoryGroup
  {
    /** The step from which the values are computed. */
    struct Step
    {
      const StepReport     &report;
      const State          &state;
      const ShellEquations &equations;
      /** The cavity; null if its volume is not of interest. */
      const Cavity *cavity;
      /** The maxima of the requested failure indices, see
       * find_failure_maxima(). */
      const std::vector<FailureMaximum> &failure_maxima;
    };

    std::vector<std::string> columns;

    /** A function that computes the values of a step, one for each column;
     * empty fields are not set. Must be called on all ranks. */
    std::function<std::vector<std::optional<double>>(const Step &)> values;

    /** Whether the values are those of StepReport::forces_of_bodies. */
    bool of_forces = false;
  };

  /** The groups of columns of history.csv that follow the step and the name of
   * the stage.
   * @param with_volume whether that of the cavity is one of them. */
  std::vector<HistoryGroup>
  history_groups(const FailureCriteria &criteria,
                 const ShellEquations  &equations,
                 const bool             with_volume);


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

    /** The names of all columns, separated by commas. */
    static std::string
    header(const FailureCriteria &criteria,
           const ShellEquations  &equations,
           const bool             with_volume);

    std::vector<std::string>
    warnings() const override;

    /** The maxima of the failure indices in the last step written. */
    const std::vector<FailureMaximum> &
    get_failure_maxima() const
    {
      return failure_maxima;
    }

  private:
    void
    write(const StepReport &report, const State &state) override;

    const FailureCriteria           criteria;
    const Cavity                   *cavity;
    const std::vector<HistoryGroup> groups;
    std::vector<FailureMaximum>     failure_maxima;
  };
} // namespace Biface

#endif
