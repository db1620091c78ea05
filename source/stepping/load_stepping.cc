// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/timer.h>

#include <memory>
#include <utility>

#include <biface/input/entry_declarations.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/work.h>
#include <biface/model/quantities/worst_strains.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/attempt_in_time.h>
#include <biface/stepping/branch_switching.h>
#include <biface/stepping/friction_continuation.h>
#include <biface/stepping/load_stepping.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_messages.h>
#include <biface/stepping/step_reporting.h>

namespace Biface
{
  using namespace dealii;

  void
  LoadSteppingParameters::add_parameters(EntryDeclarations &prm)
  {
    control.add_parameters(prm);
    prm.add_parameter("Predictor",
                      predict,
                      "Whether steps in load or force control start from "
                      "displacements extrapolated from the last step, which "
                      "saves iterations.",
                      Patterns::Bool());
  }


  LoadStepping::LoadStepping(const Parameters         &parameters,
                             const ShellEquations     &equations,
                             const ContactInteraction &contact,
                             const RollingHeat        *heat,
                             Newton                   &newton,
                             Newton                   &newton_in_time,
                             const NestedPredictor    &nested,
                             BucklingAnalysis         &buckling_analysis,
                             const StageAnalyses      &analyses,
                             ConditionalOStream       &out)
    : parameters(parameters)
    , equations(equations)
    , contact(contact)
    , heat(heat)
    , newton(newton)
    , newton_in_time(newton_in_time)
    , nested(nested)
    , analyses(analyses)
    , critical_points(buckling_analysis, out)
    , out(out)
  {}


  LoadSteppingResult
  LoadStepping::run(const std::vector<Stage> &stages,
                    Progress                 &progress,
                    State                    &state,
                    StageEnds                &ends,
                    const Observer           &observer)
  {
    while (true)
      {
        StageRun run(stages,
                     parameters.control,
                     equations,
                     contact,
                     heat,
                     progress,
                     state);
        // those of the last step belong to the loads and laws of its stage
        forces.reset();
        if (!progress.stage_begun)
          start_stage(run, stage_before(stages, progress.stage));

        bool failed = false;
        while (!run.is_complete() && !failed)
          {
            auto step = next_step(run);
            if (const auto *failure = std::get_if<LoadSteppingResult>(&step))
              {
                // a signal says nothing about the stage, which a restart
                // continues
                if (failure->stopped || !run.stage.may_fail)
                  return *failure;
                out << "  " << run.stage.name
                    << " is left out: " << failure->message << std::endl;
                progress.failed_stages[progress.stage] = failure->message;
                failed                                 = true;
                continue;
              }
            StepReport &report = std::get<StepReport>(step);
            // before the observer writes the report, to which analyses add
            if (run.is_complete())
              for (const auto &analysis : analyses)
                analysis->end_stage(run, report);
            observer(report, state);
          }

        if (!failed)
          progress.end_stage(run.stage);
        if (!failed && is_branched_from(stages, progress.stage))
          {
            RestorePoint end{state, progress};
            // a stage starts with its own control and without prediction
            end.progress.control = Control::Memory();
            end.progress.predictor.reset();
            ends.insert_or_assign(progress.stage, std::move(end));
          }
        if (!go_on(stages, ends, progress, state))
          return {};
      }
  }


  bool
  LoadStepping::go_on(const std::vector<Stage> &stages,
                      const StageEnds          &ends,
                      Progress                 &progress,
                      State                    &state)
  {
    // a stage without the equilibrium from which it starts cannot be computed:
    // failures pass on along the tree
    unsigned int next = progress.stage + 1;
    for (;; ++next)
      {
        if (next > parameters.last_stage || next >= stages.size())
          return false;
        const Stage &start = stages[*stage_before(stages, next)];
        if (!progress.has_failed(*stage_before(stages, next)))
          break;
        progress.failed_stages[next] =
          "the stage from which it starts failed: " + start.name;
      }
    const unsigned int before = *stage_before(stages, next);
    // stages are branches of a tree: the end of the one before may have been
    // passed since, but its steps and tests count on
    if (before != progress.stage)
      {
        const RestorePoint &end     = ends.at(before);
        const unsigned int  n_steps = progress.n_steps;
        const auto          failed  = progress.failed_stages;
        state                       = end.state;
        progress                    = end.progress;
        progress.n_steps            = n_steps;
        progress.failed_stages      = failed;
        out << "Start of " << stages[next].name << " from the end of stage "
            << before + 1 << ", " << stages[before].name << std::endl;
      }
    progress.stage       = next;
    progress.stage_begun = false;
    return true;
  }


  void
  LoadStepping::start_stage(StageRun                          &run,
                            const std::optional<unsigned int> &before)
  {
    if (const auto unbalance = run.start())
      print(run, *unbalance, out);
    // a zone of the coarser mesh that failed in one stage may fit the next
    trust_nested = true;
    for (const auto &analysis : analyses)
      analysis->start_stage(run, before);
  }


  namespace
  {
    /** " after 2 bisections and 84 iterations"; empty for none. */
    std::string
    bisections(const unsigned int n, const unsigned int n_iterations)
    {
      if (n == 0)
        return {};
      return " after " + std::to_string(n) +
             (n == 1 ? " bisection and " : " bisections and ") +
             std::to_string(n_iterations) + " iterations";
    }
  } // namespace


  Attempt
  LoadStepping::try_proposed_step(StageRun &run, Control::Trial &trial)
  {
    trial = run.control->propose(run.last_converged());
    if (run.progress.branch.size() > 0)
      {
        Control::Trial to_branch = trial;
        announce(run, trial, out);
        const auto attempt = attempt_other_branch(newton, run, to_branch, out);
        // a run that was stopped continues with it
        if (attempt && attempt->result.stopped)
          return *attempt;
        run.progress.branch = LA::Vector();
        if (attempt)
          {
            trial = to_branch;
            return *attempt;
          }
      }

    Attempt attempt = try_step(run, trial);
    if (attempt.result.converged)
      // an arc may end beyond the loads of the stage, which must be met exactly
      if (const auto other = run.control->replace(trial, attempt.mu))
        {
          out
            << "  the step passes the loads of the stage and is repeated with "
               "these"
            << std::endl;
          const unsigned int spent = attempt.result.iterations;
          trial                    = *other;
          attempt                  = try_step(run, trial);
          attempt.result.iterations += spent;
        }
    return attempt;
  }


  std::variant<StepReport, LoadSteppingResult>
  LoadStepping::next_step(StageRun &run)
  {
    if (const std::string message = run.control->stop_reason();
        !message.empty())
      {
        LoadSteppingResult failure = failure_at(run, run.progress.reached);
        failure.message            = message;
        failure.failure            = {FailureCause::too_many_steps, message};
        return failure;
      }
    // a step that cannot converge ends in bounded time; those in time become
    // easier the shorter they are
    const unsigned int max_iterations = (run.stage.inertia ? 1000 : 150);
    unsigned int       n_cuts = 0, n_iterations = 0;
    while (true)
      {
        // The time of a step is that of its last attempt alone.
        Timer          timer;
        Control::Trial trial;
        Attempt        attempt = try_proposed_step(run, trial);
        n_iterations += attempt.result.iterations;
        attempt.n_cuts = n_cuts;
        if (attempt.result.converged)
          {
            StepReport report = accept_to_critical_point(run, trial, attempt);
            // the bisection may have been stopped by a signal
            if (!attempt.result.stopped)
              {
                report.seconds = timer.wall_time();
                return report;
              }
          }

        Failure &why = attempt.result.failure;
        if (!attempt.result.stopped)
          {
            if (why.cause == FailureCause::error_in_time &&
                run.control->shorten(attempt.error_in_time))
              {
                out << "  " << why.message << "; shortening it" << std::endl;
                n_iterations -= attempt.result.iterations;
                continue;
              }
            out << "  not converged: " << why.message << std::endl;
            // a smaller step has the same matrix
            const bool may_help = (why.cause != FailureCause::out_of_memory);
            why.iterations_used_up =
              (may_help && n_iterations >= max_iterations);
            if (may_help && !why.iterations_used_up && run.control->cut())
              {
                out << "  halving the step" << std::endl;
                ++n_cuts;
                continue;
              }
          }
        return failure_of(run, trial, attempt.result, n_cuts, n_iterations);
      }
  }


  LoadSteppingResult
  LoadStepping::failure_at(const StageRun &run, const LoadLevel &tried) const
  {
    LoadSteppingResult failure;
    failure.success = false;
    failure.in_use  = run.stage.in_use(run.progress.stage);
    failure.reached = run.progress.reached;
    failure.tried   = tried;
    return failure;
  }


  LoadSteppingResult
  LoadStepping::failure_of(const StageRun       &run,
                           const Control::Trial &trial,
                           const NewtonResult   &result,
                           const unsigned int    n_cuts,
                           const unsigned int    n_iterations) const
  {
    LoadSteppingResult failure = failure_at(run, trial.level(trial.mu));
    failure.stopped            = result.stopped;
    failure.failure            = result.failure;
    failure.message            = result.failure.message;
    if (failure.stopped)
      return failure;
    failure.n_negative_pivots = result.exact_pivots();
    // of the last equilibrium, not of an iterate that diverged; there is none
    // before the first step
    if (run.progress.n_steps > 0 && result.failure.may_lie_in_the_wall())
      {
        failure.worst =
          worst_strains(equations.mesh, equations.internal_forces(), run.state);
        if (const auto &node = result.failure.moved_most)
          failure.worst->short_wave = softest_short_wave(
            equations.mesh, equations.internal_forces(), run.state, *node);
      }
    failure.message = "step " + std::to_string(run.progress.n_steps + 1) +
                      " (" + run.stage.name + ") did not converge" +
                      bisections(n_cuts, n_iterations) + ": " + failure.message;
    if (result.failure.iterations_used_up)
      failure.message += "; the iterations of the step are used up";
    return failure;
  }


  Attempt
  LoadStepping::try_step(const StageRun &run, const Control::Trial &trial)
  {
    announce(run, trial, out);
    if (run.stage.inertia)
      return attempt_step_in_time(newton_in_time, run, trial);
    // each further attempt below answers another cause of divergence
    const InitialGuess guess = predict(run, trial, true);
    Attempt            attempt =
      attempt_step(newton, run, trial, guess, NewtonIteration::mixed);
    if (attempt.result.failed() && guess.zone_given)
      {
        out << "  not converged: " << attempt.result.failure.message
            << "; starting from the last steps instead" << std::endl;
        const unsigned int spent = attempt.result.iterations;
        trust_nested             = false;
        attempt                  = attempt_step(newton,
                               run,
                               trial,
                               predict(run, trial, true),
                               NewtonIteration::mixed);
        attempt.result.iterations += spent;
      }
    // where the ground has moved by more than the elastic slip, all nodes
    // would slip at first, however short the step, and nothing would hold a
    // shell that is soft sideways. Before the substituted iteration, which then
    // goes far away, and may find another equilibrium there
    if (attempt.result.failed() && !run.rolls && run.stage.contact &&
        run.laws.has_friction() &&
        attempt.result.failure.cause != FailureCause::out_of_memory)
      {
        out << "  not converged: " << attempt.result.failure.message
            << "; trying with nodes that stick at first" << std::endl;
        const unsigned int spent = attempt.result.iterations;
        attempt                  = attempt_step(newton,
                               run,
                               trial,
                               {run.state, trial.mu, true},
                               NewtonIteration::mixed);
        attempt.result.iterations += spent;
      }
    // another iteration has the same matrix
    if (attempt.result.failed() &&
        attempt.result.failure.cause != FailureCause::out_of_memory)
      {
        out << "  not converged: " << attempt.result.failure.message
            << "; trying the substituted iteration" << std::endl;
        const unsigned int spent = attempt.result.iterations;
        // the secant may be misleading; the coarser mesh has a solution
        attempt = attempt_step(newton,
                               run,
                               trial,
                               predict(run, trial, false),
                               NewtonIteration::substituted);
        attempt.result.iterations += spent;
      }
    if (attempt.result.failed())
      return attempt_with_easier_friction(newton, run, trial, attempt, out);
    return attempt;
  }


  InitialGuess
  LoadStepping::predict(const StageRun       &run,
                        const Control::Trial &trial,
                        const bool            secant) const
  {
    InitialGuess  guess{run.state, trial.mu};
    const Instant from = run.instant();
    const Instant to{from.stage, from.fraction + trial.size};
    // without a size, as in arc length, nothing changes in proportion to the
    // step
    if (trial.size == 0)
      return guess;
    guess.zone_given =
      trust_nested && nested.predict(equations.mesh, from, to, guess.state);
    if (!guess.zone_given && secant && parameters.predict)
      run.progress.predictor.predict(guess.state, guess.mu, trial.size);
    return guess;
  }


  StepReport
  LoadStepping::accept_to_critical_point(StageRun       &run,
                                         Control::Trial &trial,
                                         Attempt        &attempt)
  {
    CriticalPointSearch::PivotCounts n_negative =
      critical_points.count(run, attempt);
    // between two branches pivots change without a critical point in the step
    const bool critical = !attempt.to_branch && n_negative.differ();
    const bool located  = critical && run.stage.locates_critical_points();
    double     part     = 1;
    if (located)
      part = critical_points.bisect(
        run,
        [&](const Control::Trial &shorter) { return try_step(run, shorter); },
        trial,
        attempt,
        n_negative);
    if (attempt.result.stopped)
      return {};

    const LoadLevel level_before   = run.progress.reached;
    run.progress.n_negative_pivots = n_negative.after;
    if (n_negative.after)
      attempt.result.set_exact_pivots(*n_negative.after);
    StepReport report = accept(run, trial, attempt);
    // the step was shortened for the critical point, not for convergence: the
    // next one is as long as this one was, also after a restart
    if (part < 1)
      {
        run.control->scale_step(1 / part);
        run.progress.control = run.control->get_memory();
      }
    if (critical)
      report.critical_point =
        critical_points.describe(run, level_before, n_negative, located);
    return report;
  }


  StepReport
  LoadStepping::accept(StageRun             &run,
                       const Control::Trial &trial,
                       Attempt              &attempt)
  {
    // the analyses below need the control, the loads and the state both before
    // and after the step
    const NewtonResult   &result       = attempt.result;
    Progress             &progress     = run.progress;
    const Control::Memory memory       = run.control->get_memory();
    const LoadLevel       level_before = progress.reached;
    const Loads           loads_before = run.loads_at(level_before);
    const Instant         start        = run.instant();
    run.control->accept({trial,
                         attempt.mu,
                         result.iterations,
                         run.state,
                         attempt.state,
                         attempt.to_branch,
                         attempt.error_in_time});
    // a step to another branch is no secant of the path
    if (attempt.to_branch)
      progress.predictor.reset();
    else if (trial.size > 0)
      {
        // from the initial guess, to which the next prediction adds it
        LoadParameters change = attempt.mu;
        add(change, -1, trial.mu);
        progress.predictor.learn(run.state, attempt.state, change, trial.size);
      }
    // the direction in which arc length goes on, section 7 of doc/theory.md
    progress.last_change = owned_part(attempt.state.displacement);
    progress.last_change -= owned_part(run.state.displacement);
    progress.reached = attempt.level;
    // before terms forget the start of a step in time
    const auto step      = attempt.state.step;
    const auto over_step = (step ? forces_over_step(run, attempt) : nullptr);
    attempt.state.step.reset();
    const Loads loads = equations.with_dependent_loads(
      attempt.state, run.loads_at(attempt.level));
    // that of a sealed gas, from which a later stage may go on
    progress.reached.pressure = loads.pressure;
    const TimeInterval time{start.time(), run.instant().time()};
    // before the force terms forget the start of the step
    for (const auto &analysis : analyses)
      analysis->follow({run,
                        level_before,
                        memory,
                        trial,
                        attempt.mu,
                        attempt.state,
                        loads,
                        time});
    equations.commit_step(run.state, loads, time, attempt.state);

    std::optional<EnergyOfMotion> motion;
    std::optional<double>         axle_moment;
    if (step)
      {
        forces = over_step;
        const EndOfStepInTime end =
          end_step_in_time(run, step, loads, *forces, attempt.state);
        progress.work += end.work;
        motion      = end.energy;
        axle_moment = end.axle_moment;
      }
    else
      {
        // those at the end of a step are kept for the start of the next one
        if (!forces)
          forces = std::make_shared<const NodalForces>(
            equations.nodal_forces(run.state, loads_before));
        const auto now = std::make_shared<const NodalForces>(
          equations.nodal_forces(attempt.state, loads));
        progress.work += work_of_step(run.contact,
                                      {run.state, loads_before, *forces},
                                      {attempt.state, loads, *now});
        forces = now;
      }
    run.state        = attempt.state;
    progress.control = run.control->get_memory();
    ++progress.n_steps;

    StepReport report        = report_step(run, loads, forces);
    report.iterations        = result.iterations;
    report.residuals         = result.residuals;
    report.n_negative_pivots = result.exact_pivots();
    report.n_heat_rounds     = attempt.n_heat_rounds;
    report.n_cuts            = attempt.n_cuts;
    report.motion            = motion;
    report.axle_moment       = axle_moment;
    for (const auto &analysis : analyses)
      analysis->end_step(run, report);
    return report;
  }
} // namespace Biface
