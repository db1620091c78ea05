// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_stepping_h
#define biface_stepping_load_stepping_h

#include <deal.II/base/conditional_ostream.h>

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <biface/model/heat/rolling_heat.h>
#include <biface/model/quantities/worst_strains.h>
#include <biface/solver/failure.h>
#include <biface/solver/newton.h>
#include <biface/stepping/attempt.h>
#include <biface/stepping/critical_point_search.h>
#include <biface/stepping/load_stepping_parameters.h>
#include <biface/stepping/nested_predictor.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/restore_point.h>
#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  struct ControlTrial;
  class EntryDeclarations;
  class NodalForces;
  class RollingHeat;
  class ShellEquations;
  struct Stage;
  class StageRun;
  struct StepReport;


  /** The result of all stages. */
  struct LoadSteppingResult
  {
    bool success = true;
    /** The reason of a failure, if a step failed after all attempts. */
    std::string message;
    /** Whether the run was stopped on request, which is not a success. */
    bool stopped = false;
    /** The failure of the last attempt, if a step failed after all attempts. */
    Failure failure;
    /** The settings of the stage of the failure. */
    InUse in_use;
    /** The loads of the last converged step, and those at the start of the last
     * attempt beyond it. */
    LoadLevel reached;
    LoadLevel tried;
    /** The worst strains of the last converged step, if a later step failed and
     * they may be the reason. */
    std::optional<WorstStrains> worst;
    /** The number of negative pivots of the last tangent of the failed step, if
     * the solver counts them. */
    std::optional<unsigned int> n_negative_pivots;
  };


  /**
   * Takes the shell through its stages in steps proposed by the Control of each
   * stage. A failed step is tried again from the restored state: after the
   * mixed iteration first with the substituted one, then, with friction, with
   * nodes that stick at first, then with half the size.
   * The last attempt of a wheel that rolls with friction starts from larger
   * critical velocities. After a success the size doubles again, up to the
   * remainder of the step of the stage, or beyond it with adaptive steps.
   */
  class LoadStepping
  {
  public:
    using Parameters = LoadSteppingParameters;

    /** A function that is called after every converged step. */
    using Observer = std::function<void(const StepReport &, const State &)>;

    /** All objects are kept by reference.
     * @param heat see StageRun.
     * @param newton_in_time see attempt_step_in_time().
     * @param nested the states of a coarser mesh from which steps start.
     * @param buckling_analysis for critical points.
     * @param analyses what accompanies the stages. */
    LoadStepping(const Parameters           &parameters,
                 const ShellEquations       &equations,
                 const ContactInteraction   &contact,
                 const RollingHeat          *heat,
                 Newton                     &newton,
                 Newton                     &newton_in_time,
                 const NestedPredictor      &nested,
                 BucklingAnalysis           &buckling_analysis,
                 const StageAnalyses        &analyses,
                 dealii::ConditionalOStream &out);

    /**
     * Run the stages, continuing from the given progress.
     *
     * @param progress, state those of the start or of an interrupted run; in
     * the end those of the last converged step. They are up to date when the
     * observer is called.
     * @param ends those of completed stages; the run adds its own.
     */
    LoadSteppingResult
    run(const std::vector<Stage> &stages,
        Progress                 &progress,
        State                    &state,
        StageEnds                &ends,
        const Observer           &observer);

  private:
    /** Go on to the next stage: to the end of the stage before it, from which
     * it starts. Stages that start from a failed one have failed, too.
     * @return whether there is a next stage. */
    bool
    go_on(const std::vector<Stage> &stages,
          const StageEnds          &ends,
          Progress                 &progress,
          State                    &state);

    /** Start a stage and what accompanies it.
     * @param before the position of the stage from whose end it starts. */
    void
    start_stage(StageRun &run, const std::optional<unsigned int> &before);

    /** Take a converged step, halved as often as needed.
     * @return its report or the failure. */
    std::variant<StepReport, LoadSteppingResult>
    next_step(StageRun &run);

    /** Attempt the step that the control proposes, along another branch if the
     * last one ended at a bifurcation and it is to be followed.
     * @param trial the step. */
    Attempt
    try_proposed_step(StageRun &run, ControlTrial &trial);

    /** Attempt a step from the last converged state, in other ways if that
     * fails. */
    Attempt
    try_step(const StageRun &run, const ControlTrial &trial);

    /** The initial guess of a step, from the coarser mesh if there is one.
     * @param secant whether to use the secant predictor if a coarser mesh does
     * not help. */
    InitialGuess
    predict(const StageRun     &run,
            const ControlTrial &trial,
            const bool          secant) const;

    /** Accept a converged attempt up to the critical point where the stage is
     * to stop, if it passes one.
     * @param attempt that of the whole step, then that accepted, or the attempt
     * that was stopped, without a report. */
    StepReport
    accept_to_critical_point(StageRun     &run,
                             ControlTrial &trial,
                             Attempt      &attempt);

    /** Accept a converged attempt, and let force terms record it. */
    StepReport
    accept(StageRun &run, const ControlTrial &trial, Attempt &attempt);

    /** The description of a failure of the stage without its reason.
     * @param tried the loads of the last attempt. */
    LoadSteppingResult
    failure_at(const StageRun &run, const LoadLevel &tried) const;

    /** The description of a failure of a step with its reason.
     * @param n_cuts, n_iterations in all attempts. */
    LoadSteppingResult
    failure_of(const StageRun     &run,
               const ControlTrial &trial,
               const NewtonResult &result,
               const unsigned int  n_cuts,
               const unsigned int  n_iterations) const;

    const Parameters            parameters;
    const ShellEquations       &equations;
    const ContactInteraction   &contact;
    const RollingHeat          *heat;
    Newton                     &newton;
    Newton                     &newton_in_time;
    const NestedPredictor      &nested;
    const StageAnalyses         analyses;
    CriticalPointSearch         critical_points;
    dealii::ConditionalOStream &out;
    /** Whether predictions of the coarser mesh are used: not for the rest of a
     * stage in which they have misled a step. */
    bool trust_nested = true;

    /** The forces on the nodes at the end of the last step; null in the first
     * step of this run of a stage. */
    std::shared_ptr<const NodalForces> forces;
  };
} // namespace Biface

#endif
