// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_analysis_h
#define biface_stepping_stage_analysis_h

#include <memory>
#include <optional>
#include <vector>

#include <biface/model/forces/force_term.h>
#include <biface/solver/control_equation.h>

namespace Biface
{
  struct ControlMemory;
  struct ControlTrial;
  struct LoadLevel;
  struct Loads;
  class StageRun;
  struct State;
  struct StepReport;


  /** Something that accompanies the stages of a run and adds its results to
   * the reports, such as natural frequencies at the end of a stage. It never
   * changes the run. All functions are called on all ranks. */
  class StageAnalysis
  {
  public:
    virtual ~StageAnalysis() = default;

    /** Called when a stage has started, from the end of the stage at the given
     * position if there is one. */
    virtual void
    start_stage(const StageRun & /*run*/,
                const std::optional<unsigned int> & /*before*/)
    {}

    /** A converged step of a run whose state is still that before the step. */
    struct Step
    {
      const StageRun &run;
      /** The loads before the step. */
      const LoadLevel &level_before;
      /** The data of the control before it accepted the step. */
      const ControlMemory &memory;
      const ControlTrial  &trial;
      /** The final load parameters. */
      LoadParameters mu;
      /** The state after the step, before ShellEquations::commit_step(). */
      const State &state;
      const Loads &loads;
      TimeInterval time;
    };

    /** Called after each converged step, before the run accepts its state. */
    virtual void
    follow(const Step & /*step*/)
    {}

    /** Called after each step, with its report. */
    virtual void
    end_step(const StageRun & /*run*/, StepReport & /*report*/)
    {}

    /** Called after the last step of a stage, with its report. */
    virtual void
    end_stage(const StageRun & /*run*/, StepReport & /*report*/)
    {}
  };


  /** The analyses of a run, in the order in which they add to a report. */
  using StageAnalyses = std::vector<std::shared_ptr<StageAnalysis>>;
} // namespace Biface

#endif
