// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_stepping_h
#define biface_stepping_load_stepping_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <biface/model/contact_interaction.h>
#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/failure.h>
#include <biface/solver/newton.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/nested_predictor.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  /** How the stages ended. */
  struct LoadSteppingResult
  {
    bool success = true;
    /** Where a step failed for good: what happened. */
    std::string message;
    /** Whether it was asked to stop; then it is no success. */
    bool stopped = false;
    /** Of a step that failed for good. */
    FailureCause cause      = FailureCause::too_many_iterations;
    bool         in_contact = false;
    /** The loads of the last converged step, and those with which the last
     * attempt beyond it started. */
    LoadLevel reached;
    LoadLevel tried;
  };


  /**
   * Takes the shell through its stages, a step at a time, as the Control of
   * each stage proposes. A step that fails is tried again from the restored
   * state: in the mixed iteration first with the substituted one, then with
   * half the size; after a success the size doubles again, up to what is left
   * of the stage's step, or beyond where the stage lets steps adapt.
   */
  class LoadStepping
  {
  public:
    struct Parameters
    {
      Control::Parameters control;
      bool                predict = true;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Called after every converged step. */
    using Observer = std::function<void(const StepReport &, const State &)>;

    /** All objects are kept by reference.
     * @param nested the states of a coarser mesh, to start steps with; null
     * without one. */
    LoadStepping(const Parameters           &parameters,
                 ShellEquations             &equations,
                 const ContactInteraction   &contact,
                 Newton                     &newton,
                 dealii::ConditionalOStream &out,
                 const NestedPredictor      *nested = nullptr);

    /**
     * Run the stages on from where the progress is.
     *
     * @param progress, state at the start, or of a run that ended early, with
     * the history of its equations; where a step failed or was stopped, they
     * are those of the last converged one. They are up to date when the
     * observer is called.
     */
    LoadSteppingResult
    run(const std::vector<Stage> &stages,
        Progress                 &progress,
        State                    &state,
        const Observer           &observer);

  private:
    /** A stage under way. */
    struct StageRun
    {
      const Stage &stage;
      Control     &control;
      Progress    &progress;
      State       &state;
    };

    /** How an attempt at a step ended, and where. */
    struct Attempt
    {
      NewtonResult result;
      State        state;
      double       mu = 0;
    };

    void
    begin_stage(const StageRun &run);

    /** One converged step, cut as often as needed.
     * @return its report, or why there is none. */
    std::variant<StepReport, LoadSteppingResult>
    next_step(const StageRun &run);

    /** An attempt from the last converged state. */
    Attempt
    try_step(const StageRun &run, const Control::Trial &trial);

    /** Newton's method from where the step probably ends.
     * @param secant whether the steps before may tell where. */
    Attempt
    iterate(const StageRun       &run,
            const Control::Trial &trial,
            const NewtonIteration iteration,
            const bool            secant);

    /** Go on from an attempt that has converged. */
    StepReport
    accept(const StageRun       &run,
           const Control::Trial &trial,
           const Attempt        &attempt);

    /** Name the held nodes that the foundation has passed through, once. */
    void
    warn_of_pierced_nodes(const State &state, const Loads &loads);

    Control::Equilibrium
    last_converged(const StageRun &run) const;

    Loads
    loads_at(const LoadLevel &level, const StageRun &run) const;

    const Parameters            parameters;
    ShellEquations             &equations;
    const ContactInteraction   &contact;
    Newton                     &newton;
    dealii::ConditionalOStream &out;
    const NestedPredictor      *nested;

    /** Whether pierced nodes were named. */
    bool warned = false;
  };
} // namespace Biface

#endif
