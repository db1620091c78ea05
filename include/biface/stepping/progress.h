// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_progress_h
#define biface_stepping_progress_h

#include <optional>
#include <vector>

#include <biface/stepping/controls/control.h>
#include <biface/stepping/secant_predictor.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /**
   * Where a run is on its way through the stages: all that LoadStepping knows
   * from one step to the next. With the State and ShellEquations::History, a
   * complete restore point: stepping goes on from a copy as from the original.
   */
  struct Progress
  {
    /** Converged steps through all stages. */
    unsigned int n_steps = 0;
    /** Position of the stage at hand, and whether it was entered. */
    unsigned int stage       = 0;
    bool         stage_begun = false;
    /** The loads of the last converged step. */
    LoadLevel reached;
    /** See ShellEquations::touching_travel(), at the start of the first stage
     * with contact, or the first one after a prestress. */
    std::optional<double> touching_travel;

    /** What the control of the stage at hand knows, if the stage has begun. */
    Control::Memory control;

    SecantPredictor predictor;

    /** Whether nothing is left to do. */
    bool
    at_end_of(const std::vector<Stage> &stages) const
    {
      return stage_begun && stage + 1 == stages.size() && control.done >= 1;
    }

    /** Take another description of the stage at hand, if it has begun, see
     * Control::change_stage(). */
    void
    change_stage(const Stage &before, const Stage &now);

    /** The numbers; vectors are distributed, and stored by themselves. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      bool   touched = touching_travel.has_value();
      double travel  = touching_travel.value_or(0);
      archive &n_steps &stage &stage_begun &reached &touched &travel;
      archive &control                                       &predictor;
      touching_travel =
        (touched ? std::optional<double>(travel) : std::nullopt);
    }
  };
} // namespace Biface

#endif
