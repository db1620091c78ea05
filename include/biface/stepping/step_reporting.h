// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_step_reporting_h
#define biface_stepping_step_reporting_h

#include <memory>

#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** Set the loads and the contact zone of the last converged state in a
   * report. */
  void
  report_contact(const StageRun &run, const Loads &loads, StepReport &report);


  /** The report of the last converged step, without the results of the
   * iteration and of analyses. Records the reaction of the ground in the
   * progress.
   * @param forces those on the nodes. */
  StepReport
  report_step(const StageRun                           &run,
              const Loads                              &loads,
              const std::shared_ptr<const NodalForces> &forces);
} // namespace Biface

#endif
