// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_rolling_report_h
#define biface_stepping_rolling_report_h

#include <deal.II/base/conditional_ostream.h>

#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /** Adds to the reports of a wheel that rolls: the forces in its axes, the
   * powers, and the slip ratio. Warns once of a wheel that spins too fast. */
  class RollingReport : public StageAnalysis
  {
  public:
    /** @param out kept by reference. */
    explicit RollingReport(dealii::ConditionalOStream &out) : out(out)
    {}

    void
    end_step(const StageRun &run, StepReport &report) override;

  private:
    /** Add the heat of the plies, and print their temperatures. */
    void
    add_heat(const StageRun &run, StepReport &report);

    /** Warn of negative pivots of a wheel with inertia, and of its largest
     * cells. */
    void
    warn_of_fast_wheel(const StageRun &run, const StepReport &report);

    dealii::ConditionalOStream &out;
    bool                        warned = false;
  };
} // namespace Biface

#endif
