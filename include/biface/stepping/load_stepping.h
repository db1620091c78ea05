// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_stepping_h
#define biface_stepping_load_stepping_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/gas.h>
#include <biface/model/quantities/worst_strains.h>
#include <biface/model/state/state.h>
#include <biface/solver/failure.h>
#include <biface/solver/newton.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/nested_predictor.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/restore_point.h>
#include <biface/stepping/stage.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  class BucklingAnalysis;
  class ModalAnalysis;
  class StepFollower;


  /** The result of all stages. */
  struct LoadSteppingResult
  {
    bool success = true;
    /** What happened, if a step failed after all attempts. */
    std::string message;
    /** Whether it was stopped on request, which is not a success. */
    bool stopped = false;
    /** The cause, if a step failed after all attempts. */
    FailureCause cause      = FailureCause::too_many_iterations;
    bool         in_contact = false;
    /** The loads of the last converged step, and those at the start of the last
     * attempt beyond it. */
    LoadLevel reached;
    LoadLevel tried;
    /** The worst strains of the last converged step, if a step failed. */
    std::optional<WorstStrains> worst;
    /** Of the last tangent of the failed step, if the solver counts them. */
    std::optional<unsigned int> n_negative_pivots;
  };


  /**
   * Takes the shell through its stages in steps proposed by the Control of each
   * stage. A failed step is tried again from the restored state: after the
   * mixed iteration first with the substituted one, then with half the size.
   * The last attempt of a wheel that rolls with friction starts from larger
   * critical velocities. After a success the size doubles again, up to the
   * remainder of the step of the stage, or beyond it with adaptive steps.
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
     * @param nested the states of a coarser mesh from which steps start; null
     * for none.
     * @param gas null if no stage has a sealed gas.
     * @param modal_analysis null if no stage asks for modes.
     * @param buckling_analysis null if no stage asks for buckling or critical
     * points.
     * @param follower null for none. */
    LoadStepping(const Parameters           &parameters,
                 ShellEquations             &equations,
                 const ContactInteraction   &contact,
                 Newton                     &newton,
                 dealii::ConditionalOStream &out,
                 const NestedPredictor      *nested            = nullptr,
                 const Gas                  *gas               = nullptr,
                 ModalAnalysis              *modal_analysis    = nullptr,
                 BucklingAnalysis           *buckling_analysis = nullptr,
                 StepFollower               *follower          = nullptr);

    /**
     * Run the stages, continuing from the given progress.
     *
     * @param progress, state those of the start or of an interrupted run, whose
     * history is in the equations; in the end those of the last converged step.
     * They are up to date when the observer is called.
     * @param ends those of completed stages; the run adds its own.
     */
    LoadSteppingResult
    run(const std::vector<Stage> &stages,
        Progress                 &progress,
        State                    &state,
        StageEnds                &ends,
        const Observer           &observer);

  private:
    /** The current stage. */
    struct StageRun
    {
      const Stage &stage;
      Control     &control;
      Progress    &progress;
      State       &state;
      /** Null without friction. */
      std::shared_ptr<const FrictionLaw> friction;
      /** See Stage::rolls(). */
      bool rolls;
      /** The forces on the nodes at the end of the last step; null in the first
       * step of this run of the stage. */
      std::shared_ptr<const NodalForces> &forces;
    };

    /** The result of an attempt at a step. */
    struct Attempt
    {
      NewtonResult   result;
      State          state;
      LoadParameters mu;
      /** The loads at the final load parameters. */
      LoadLevel level;
      /** Whether it has left the path for another branch. */
      bool to_branch = false;
    };

    /** Go on to the next stage: to the end of the stage before it, from which
     * it starts. */
    void
    go_on(const std::vector<Stage> &stages,
          const StageEnds          &ends,
          Progress                 &progress,
          State                    &state);

    void
    begin_stage(const StageRun &run);

    /** Print what is out of balance in a start from a prestress. */
    void
    print(const StageRun &run, const ShellEquations::Unbalance &unbalance);

    /** A converged step, halved as often as needed.
     * @return its report or the failure. */
    std::variant<StepReport, LoadSteppingResult>
    next_step(const StageRun &run);

    /** Print the number and the loads of a step. */
    void
    announce(const StageRun &run, const Control::Trial &trial) const;

    /** An attempt from the last converged state. */
    Attempt
    try_step(const StageRun &run, const Control::Trial &trial);

    /** An attempt from the last converged state after all others failed: with
     * larger critical velocities of friction, for which it is viscous and
     * gentle, down to the given one.
     * @param failed what is returned if this fails, too. */
    Attempt
    try_gentle_friction(const StageRun       &run,
                        const Control::Trial &trial,
                        const Attempt        &failed);

    /** Newton's method from the predicted state.
     * @param secant whether to use the secant predictor. */
    Attempt
    iterate(const StageRun       &run,
            const Control::Trial &trial,
            const NewtonIteration iteration,
            const bool            secant);

    /** Newton's method from a given state and load parameters.
     * @param zone_given see Newton::solve(). */
    Attempt
    converge(const StageRun       &run,
             const Control::Trial &trial,
             const State          &guess,
             const LoadParameters &mu,
             const NewtonIteration iteration,
             const bool            zone_given = false);

    /** The number of negative pivots of a converged attempt, if it is known:
     * exact if the stage locates critical points, otherwise that of the last
     * iterate. */
    std::optional<unsigned int>
    negative_pivots(const StageRun &run, const Attempt &attempt);

    /**
     * Shorten a step in which the number of negative pivots changes to end
     * where it does, see CriticalPoints.
     *
     * @param attempt, n_negative those of the whole step, then those of the
     * shortened one, or the attempt that was stopped.
     * @return the part of the step that is left.
     */
    double
    bisect(const StageRun              &run,
           Control::Trial              &trial,
           Attempt                     &attempt,
           std::optional<unsigned int> &n_negative);

    /** Describe and print the critical point of the last step.
     * @return null if its shape was not found. */
    std::shared_ptr<const CriticalPoint>
    critical_point(const StageRun    &run,
                   const LoadLevel   &level_before,
                   const unsigned int n_before,
                   const unsigned int n_after,
                   const bool         located);

    /** A step to the other branch at a bifurcation, where the last one ended.
     * @param trial that step.
     * @return none if the branch was not found. */
    std::optional<Attempt>
    try_branch(const StageRun &run, Control::Trial &trial);

    /** Accept a converged attempt, and record its history of friction. */
    StepReport
    accept(const StageRun &run, const Control::Trial &trial, Attempt &attempt);

    /** The stiffness of the last step, if the foundation alone has moved.
     * @param before that of the step before. */
    std::optional<StepStiffness>
    stiffness(const StageRun                          &run,
              const std::optional<FoundationReaction> &before) const;

    /** Whether the follower reads the left eigenvectors at the end of a stage.
     */
    bool
    wants_left_eigenvectors(const StageRun &run) const;

    /** Compute the modes of the end of a stage and print their frequencies.
     * @return null if they were not found. */
    std::shared_ptr<const VibrationModes>
    find_modes(const StageRun &run, const Loads &loads);

    /** Predict buckling at the end of a stage and print the factors.
     * @param before_step the equilibrium before the last step.
     * @return null if the prediction failed. */
    std::shared_ptr<const Buckling>
    find_buckling(const StageRun &run, const EarlierEquilibrium &before_step);

    /** Warn once of supported nodes that the foundation has passed through. */
    void
    warn_of_pierced_nodes(const State &state, const Loads &loads);

    /** Warn once of negative pivots of a wheel with inertia, and of its largest
     * cells. */
    void
    warn_of_fast_wheel(const StepReport &report);

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
    const Gas                  *gas;
    ModalAnalysis              *modal_analysis;
    BucklingAnalysis           *buckling_analysis;
    StepFollower               *follower;

    /** Whether these warnings were given. */
    bool warned_of_pierced_nodes   = false;
    bool warned_of_fast_wheel      = false;
    bool warned_of_critical_points = false;
  };
} // namespace Biface

#endif
