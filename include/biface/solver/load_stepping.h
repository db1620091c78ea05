// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_load_stepping_h
#define biface_solver_load_stepping_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/nested_predictor.h>
#include <biface/solver/newton.h>
#include <biface/solver/secant_predictor.h>
#include <biface/solver/stage.h>

namespace Biface
{
  /** A converged step, as reported. */
  struct StepReport
  {
    /** Counted from 1 through all stages. */
    unsigned int step = 0;
    /** Where the step ended, for steps of the loads or of the force. */
    std::optional<Moment> moment;
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
    double              seconds = 0;
  };


  /** How the stages ended. */
  struct LoadSteppingResult
  {
    bool success = true;
    /** Where a step failed for good: what happened. */
    std::string message;
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

    /** Run the stages from a state, which is the last converged one at the
     * end. */
    LoadSteppingResult
    run(const std::vector<Stage> &stages,
        State                    &state,
        const Observer           &observer);

  private:
    /** Loads and foundation travel at some moment. */
    struct LoadPoint
    {
      double pressure = 0;
      double factor   = 0;
      double travel   = 0;
    };

    /** Where the stage at hand is on its way. */
    struct Progress
    {
      LoadPoint begin;
      /** Fraction of the way from the begin to the stage's loads. */
      double fraction = 0;
    };

    /** Fractions of the stage at hand. */
    struct Span
    {
      double from, to;
    };

    LoadSteppingResult
    run_stage(const Stage &stage, State &state, const Observer &observer);

    /** Steps of given fractions of the stage.
     * @param step_to a step to a given fraction; whether it converged. */
    LoadSteppingResult
    follow_fractions(const Stage                             &stage,
                     Progress                                &progress,
                     const std::function<bool(const double)> &step_to);

    /** Steps of given loads. */
    LoadSteppingResult
    follow_loads(const Stage    &stage,
                 Progress       &progress,
                 State          &state,
                 const Observer &observer);

    /** Steps of a given force on the foundation. */
    LoadSteppingResult
    follow_force(const Stage    &stage,
                 Progress       &progress,
                 State          &state,
                 const Observer &observer);

    /** Steps of a given displacement. */
    LoadSteppingResult
    follow_displacement(const Stage    &stage,
                        Progress       &progress,
                        State          &state,
                        const Observer &observer);

    /** Steps of a given length, until the stage's loads are reached. */
    LoadSteppingResult
    follow_arc(const Stage    &stage,
               Progress       &progress,
               State          &state,
               const Observer &observer);

    /**
     * One step from the last converged state.
     *
     * @param point the loads by one number, such as the fraction of the stage.
     * @param number to reach, or, with @p control, to begin with; then the one
     * reached.
     * @param span the fractions of the stage between which the step leads, for
     * the predictors; none where they are not given.
     * @return whether it converged; the state then is the new one, and the step
     * has been reported.
     */
    bool
    step(const Stage                                  &stage,
         const std::function<LoadPoint(const double)> &point,
         double                                       &number,
         const std::optional<Span>                    &span,
         const PathControl                            *control,
         State                                        &state,
         const Observer                               &observer);

    /** A step to a fraction of the stage, given or chosen by @p control; moves
     * the progress. */
    bool
    fraction_step(const Stage       &stage,
                  Progress          &progress,
                  const double       guess,
                  const PathControl *control,
                  State             &state,
                  const Observer    &observer);

    NewtonResult
    try_step(State                     &state,
             const Newton::Path        &path,
             double                    &number,
             const std::optional<Span> &span);

    /** Move a state to where a step probably ends.
     * @return whether the contact zone was moved, too. */
    bool
    predict(const Span &span, State &state) const;

    /** How the loads change over the whole stage. */
    static Loads
    rate(const Stage &stage, const Progress &progress);

    LoadPoint
    point_at(const Stage    &stage,
             const Progress &progress,
             const double    fraction) const;

    Loads
    loads_at(const LoadPoint &point, const Stage &stage) const;

    LoadSteppingResult
    failure(const Stage &stage) const;

    const Parameters            parameters;
    ShellEquations             &equations;
    Newton                     &newton;
    dealii::ConditionalOStream &out;
    const NestedPredictor      *nested;

    /** Position of the stage at hand. */
    unsigned int    stage_number = 0;
    SecantPredictor predictor;
    LoadPoint       reached;
    unsigned int    n_steps           = 0;
    unsigned int    last_n_iterations = 0;
    std::string     last_message;
    /** The plane as it touches the shell at the begin of the first stage with
     * contact, or the first one after a prestress. */
    std::optional<RigidPlane> touching_plane;
  };
} // namespace Biface

#endif
