// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_stepping_h
#define biface_stepping_load_stepping_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <string>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/failure_cause.h>
#include <biface/solver/newton.h>
#include <biface/stepping/nested_predictor.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  /** A converged step, as reported. */
  struct StepReport
  {
    /** Counted from 1 through all stages. */
    unsigned int step = 0;
    /** Where the step ended, for steps of the loads or of the force. */
    std::optional<Instant> instant;
    /** Name of the stage, and whether it has a foundation. */
    std::string stage;
    bool        in_contact = false;
    Loads       loads;
    /** Travel of the foundation since it touched the shell. */
    double         approach = 0;
    ContactSummary contact;
    unsigned int   iterations = 0;
    /** Relative residuals before each iteration, and after the last. */
    std::vector<double> residuals;
    /** See NewtonResult. */
    std::optional<unsigned int> n_negative_pivots;
    double                      seconds = 0;
  };


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
     * attempt beyond it began. */
    LoadLevel reached;
    LoadLevel tried;
  };


  /**
   * Takes the shell through its stages, a step at a time. Steps are equal in
   * the loads, in a displacement or in the force on the foundation, or adapt
   * their length along the path of equilibrium. A step that fails is tried
   * again from the restored state: in the mixed iteration first with the
   * substituted one, then with half the size; after a success the size doubles
   * again, up to what is left of the stage's step, or beyond where the stage
   * lets steps adapt.
   */
  class LoadStepping
  {
  public:
    struct Parameters
    {
      unsigned int max_cuts        = 6;
      unsigned int max_arc_steps   = 1000;
      double       greatest_growth = 10;
      bool         predict         = true;

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Called after every converged step. */
    using Observer = std::function<void(const StepReport &, const State &)>;

    /** All objects are kept by reference.
     * @param nested the path of a coarser mesh, to begin steps with; null
     * without one. */
    LoadStepping(const Parameters           &parameters,
                 ShellEquations             &equations,
                 Newton                     &newton,
                 dealii::ConditionalOStream &out,
                 const NestedPredictor      *nested = nullptr);

    /**
     * Run the stages on from where the progress is.
     *
     * @param progress, state at the begin, or of a run that ended early, with
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
    /** How an attempt at a step ended. */
    enum class Attempt
    {
      converged,
      failed,
      stopped
    };

    void
    begin_stage(const Stage &stage, Progress &progress, State &state);

    /** One converged step, cut as often as needed. */
    LoadSteppingResult
    next_step(const Stage &stage, Progress &progress, State &state);

    /** A step of given loads or a given force. */
    Attempt
    step_of_loads(const Stage &stage, Progress &progress, State &state);

    /** A step of a given displacement. */
    Attempt
    step_of_displacement(const Stage &stage, Progress &progress, State &state);

    /** A step of given length; the first is one of the loads, and gives the
     * length of the later ones. */
    Attempt
    step_of_arc(const Stage &stage, Progress &progress, State &state);

    /**
     * One step from the last converged state.
     *
     * @param point the loads by one number, such as the fraction of the stage.
     * @param number to reach, or, with @p control, to begin with; then the one
     * reached.
     * @param size of the step, as a fraction of the stage, for the predictor;
     * 0 where it does not know.
     * @return where it converged, the state is the new one, and the report that
     * of the step.
     */
    Attempt
    step(const Stage                                  &stage,
         const std::function<LoadLevel(const double)> &point,
         double                                       &number,
         const double                                  size,
         const PathControl                            *control,
         Progress                                     &progress,
         State                                        &state);

    /** A step to a fraction of the stage, given or chosen by @p control; moves
     * the progress. */
    Attempt
    fraction_step(const Stage       &stage,
                  const double       guess,
                  const PathControl *control,
                  Progress          &progress,
                  State             &state);

    /** A step to a given force on the foundation, and to the loads of the given
     * fraction. */
    Attempt
    force_step(const Stage &stage,
               const double fraction,
               Progress    &progress,
               State       &state);

    NewtonResult
    try_step(State              &state,
             const Newton::Path &path,
             double             &number,
             const double        size,
             const Progress     &progress);

    /** Move a state to where a step of given size probably ends.
     * @return whether the contact zone was moved, too. */
    bool
    predict(const double size, const Progress &progress, State &state) const;

    /** How the loads change over the whole stage. */
    static Loads
    rate(const Stage &stage, const Progress &progress);

    LoadLevel
    point_at(const Stage    &stage,
             const Progress &progress,
             const double    fraction) const;

    Loads
    loads_at(const LoadLevel &point,
             const Stage     &stage,
             const Progress  &progress) const;

    const Parameters            parameters;
    ShellEquations             &equations;
    Newton                     &newton;
    dealii::ConditionalOStream &out;
    const NestedPredictor      *nested;

    /** Of the last converged step. */
    StepReport report;
    /** Of the last attempt that did not converge: how its iteration ended, and
     * with which loads it began. */
    NewtonResult last_failure;
    LoadLevel    last_tried;
  };
} // namespace Biface

#endif
