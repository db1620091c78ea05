// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_step_follower_h
#define biface_stepping_step_follower_h

#include <memory>

#include <biface/model/state/state.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/sensitivity_table.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** Accompanies the steps of a run, such as to carry derivatives along; it
   * never changes the run. All functions are called on all ranks. */
  class StepFollower
  {
  public:
    virtual ~StepFollower() = default;

    /** A stage has started.
     * @param before, position the stage from whose end it starts, if any, and
     * its own position. */
    virtual void
    start_stage(const std::optional<unsigned int> &before,
                const unsigned int                 position) = 0;

    /** A converged step. */
    struct Step
    {
      const Stage &stage;
      /** Of the stage. */
      unsigned int position;
      /** Of the control, before it accepted the step. */
      const Control::Memory &memory;
      const Control::Trial  &trial;
      /** The final load parameters. */
      LoadParameters mu;
      /** The state before the history of friction is recorded. */
      const State &state;
      const Loads &loads;
      /** Whether the stage is complete. */
      bool completes_stage;
    };

    virtual void
    follow(const Step &step) = 0;

    /** Whether end_stage() reads the left eigenvectors of the modes of
     * vibration or buckling at the end of a stage. */
    virtual bool
    reads_left_eigenvectors(const unsigned int stage) const = 0;

    /** The derivatives at the end of a stage, null if there are none. */
    virtual std::shared_ptr<const SensitivityTable>
    end_stage(const StepReport &report, const State &state) = 0;
  };
} // namespace Biface

#endif
