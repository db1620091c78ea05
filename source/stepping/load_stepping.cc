// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>

#include <biface/input/parameter_tools.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/work.h>
#include <biface/solver/active_set_iteration.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/critical_point.h>
#include <biface/stepping/load_stepping.h>
#include <biface/stepping/stage_start.h>
#include <biface/stepping/step_follower.h>

namespace Biface
{
  using namespace dealii;

  void
  LoadStepping::Parameters::add_parameters(ParameterHandler &prm)
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
                             ShellEquations           &equations,
                             const ContactInteraction &contact,
                             Newton                   &newton,
                             ConditionalOStream       &out,
                             const NestedPredictor    *nested,
                             const Gas                *gas,
                             ModalAnalysis            *modal_analysis,
                             BucklingAnalysis         *buckling_analysis,
                             StepFollower             *follower)
    : parameters(parameters)
    , equations(equations)
    , contact(contact)
    , newton(newton)
    , out(out)
    , nested(nested)
    , gas(gas)
    , modal_analysis(modal_analysis)
    , buckling_analysis(buckling_analysis)
    , follower(follower)
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
        std::shared_ptr<const NodalForces> forces;
        const Stage                        stage =
          progress.with_angular_velocity(stages[progress.stage]);
        const auto     control = make_control(stage, parameters.control);
        const StageRun run{
          stage,
          *control,
          progress,
          state,
          contact.friction("Stage " + std::to_string(progress.stage + 1) +
                             "/Friction",
                           stage.friction,
                           stage.glued),
          stage.rolls(progress.stage_begun ? progress.control.start
                                           : progress.reached),
          forces};

        if (progress.stage_begun)
          control->restore(progress.control);
        else
          {
            begin_stage(run);
            if (follower)
              follower->start_stage(stage_before(stages, progress.stage),
                                    progress.stage);
          }

        while (control->done() < 1)
          {
            const std::optional<State> before =
              (stage.n_buckling > 0 ? std::make_optional(state) : std::nullopt);
            const LoadLevel level_before = progress.reached;
            auto            step         = next_step(run);
            if (const auto *failure = std::get_if<LoadSteppingResult>(&step))
              return *failure;
            StepReport &report = std::get<StepReport>(step);
            if (stage.n_modes > 0 && control->done() >= 1)
              report.modes = find_modes(run, report.loads);
            if (before && control->done() >= 1)
              report.buckling = find_buckling(run, {*before, level_before});
            if (follower && control->done() >= 1)
              report.sensitivities = follower->end_stage(report, state);
            observer(report, state);
          }

        progress.end_stage(stage);
        if (is_branched_from(stages, progress.stage))
          {
            RestorePoint end{
              state, equations.internal_forces().get_history(), progress};
            // a stage begins with its own control and without prediction
            end.progress.control = Control::Memory();
            end.progress.predictor.reset();
            ends.insert_or_assign(progress.stage, std::move(end));
          }
        if (progress.stage + 1 == stages.size())
          return {};
        go_on(stages, ends, progress, state);
      }
  }


  void
  LoadStepping::go_on(const std::vector<Stage> &stages,
                      const StageEnds          &ends,
                      Progress                 &progress,
                      State                    &state)
  {
    const unsigned int next   = progress.stage + 1;
    const unsigned int before = *stage_before(stages, next);
    if (before != progress.stage)
      {
        const RestorePoint &end     = ends.at(before);
        const unsigned int  n_steps = progress.n_steps;
        state                       = end.state;
        equations.internal_forces().restore(end.history);
        progress         = end.progress;
        progress.n_steps = n_steps;
        out << "Start of " << stages[next].name << " from the end of stage "
            << before + 1 << ", " << stages[before].name << std::endl;
      }
    progress.stage       = next;
    progress.stage_begun = false;
  }


  void
  LoadStepping::begin_stage(const StageRun &run)
  {
    const Stage &stage    = run.stage;
    Progress    &progress = run.progress;
    if (const auto unbalance = start_stage(
          stage, run.rolls, equations, contact, gas, progress, run.state))
      print(run, *unbalance);

    run.control.begin(last_converged(run));
    progress.control = run.control.get_memory();
    progress.predictor.reset();
    progress.stage_begun = true;
  }


  void
  LoadStepping::print(const StageRun                  &run,
                      const ShellEquations::Unbalance &unbalance)
  {
    const bool   loaded = unbalance.loads > 0;
    const double whole  = (loaded ? unbalance.loads : unbalance.with_supports);
    double       part   = (whole > 0 ? unbalance.forces / whole : 0.);
    // round-off
    if (part < 1e-10)
      part = 0;
    std::ostringstream number;
    number << std::setprecision(3) << part;
    out << "Start of " << run.stage.name << " from prestress: " << number.str()
        << (loaded ? " of the loads" : " of the forces of the supports")
        << " is out of balance in the undeformed shape" << std::endl;
  }


  namespace
  {
    /** " after 2 bisections"; empty for none. */
    std::string
    bisections(const unsigned int n)
    {
      if (n == 0)
        return {};
      return " after " + std::to_string(n) +
             (n == 1 ? " bisection" : " bisections");
    }
  } // namespace


  std::variant<StepReport, LoadSteppingResult>
  LoadStepping::next_step(const StageRun &run)
  {
    LoadSteppingResult failure;
    failure.success    = false;
    failure.in_contact = run.stage.contact;
    failure.reached = failure.tried = run.progress.reached;
    failure.message                 = run.control.exhausted();
    failure.cause                   = FailureCause::too_many_steps;
    if (!failure.message.empty())
      return failure;

    Progress &progress = run.progress;
    while (true)
      {
        Timer          timer;
        Control::Trial trial = run.control.propose(last_converged(run));
        Attempt        attempt;
        bool           on_branch = false;
        if (progress.branch.size() > 0)
          {
            Control::Trial to_branch = trial;
            if (const auto branch = try_branch(run, to_branch))
              {
                trial     = to_branch;
                attempt   = *branch;
                on_branch = true;
              }
            progress.branch = LA::Vector();
          }
        if (!on_branch)
          attempt = try_step(run, trial);
        if (attempt.result.converged && !on_branch)
          if (const auto other = run.control.replace(trial, attempt.mu))
            {
              out << "  beyond the loads of the stage: trying these"
                  << std::endl;
              const unsigned int spent = attempt.result.iterations;
              attempt                  = try_step(run, *other);
              attempt.result.iterations += spent;
            }
        if (attempt.result.converged)
          {
            std::optional<unsigned int> n_negative =
              negative_pivots(run, attempt);
            const std::optional<unsigned int> n_before =
              progress.n_negative_pivots;
            const bool critical =
              !on_branch && n_negative && n_before && *n_negative != *n_before;
            const bool located =
              critical && run.stage.locates_critical_points();
            const double part =
              (located ? bisect(run, trial, attempt, n_negative) : 1.);
            if (!attempt.result.stopped)
              {
                const LoadLevel level_before = progress.reached;
                StepReport      report       = accept(run, trial, attempt);
                if (part < 1)
                  {
                    run.control.scale_step(1 / part);
                    progress.control = run.control.get_memory();
                  }
                if (critical)
                  report.critical_point = critical_point(
                    run, level_before, *n_before, *n_negative, located);
                if (n_negative)
                  progress.n_negative_pivots = n_negative;
                report.seconds = timer.wall_time();
                return report;
              }
          }

        const Failure &why = attempt.result.failure;
        if (!attempt.result.stopped)
          {
            out << "  not converged: " << why.message << std::endl;
            if (run.control.cut())
              {
                out << "  halving the step" << std::endl;
                continue;
              }
          }
        failure.stopped = attempt.result.stopped;
        failure.cause   = why.cause;
        failure.tried   = trial.level(trial.mu);
        failure.message = why.message;
        if (!failure.stopped)
          {
            failure.n_negative_pivots = attempt.result.n_negative_pivots;
            if (run.progress.n_steps > 0)
              failure.worst = worst_strains(
                equations.mesh, equations.internal_forces(), run.state);
            failure.message =
              "step " + std::to_string(run.progress.n_steps + 1) + " (" +
              run.stage.name + ") did not converge" +
              bisections(parameters.control.max_cuts) + ": " + why.message;
          }
        return failure;
      }
  }


  void
  LoadStepping::announce(const StageRun &run, const Control::Trial &trial) const
  {
    const LoadLevel first = trial.level(trial.mu);
    out << "Step " << run.progress.n_steps + 1 << ", " << run.stage.name
        << ": pressure ";
    if (run.stage.sealed)
      out << run.progress.reached.pressure << " at its start";
    else
      out << first.pressure;
    out << ", load factor " << first.factor;
    if (run.stage.contact)
      {
        out << ", approach " << first.travel;
        if (first.slide.norm() > 0)
          out << ", slide " << vector_to_string(first.slide);
        if (first.turn != 0)
          out << ", turn " << first.turn;
        if (first.wheel_turn != 0)
          out << ", wheel turned by " << first.wheel_turn;
      }
    if (run.rolls)
      {
        out << ", angular velocity " << first.angular_velocity;
        if (first.ground_velocity != 0)
          out << ", ground velocity " << first.ground_velocity;
        if (first.slip_angle != 0)
          out << ", slip angle " << first.slip_angle;
      }
    out << (trial.equations ? " at its start" : "") << std::endl;
  }


  LoadStepping::Attempt
  LoadStepping::try_step(const StageRun &run, const Control::Trial &trial)
  {
    announce(run, trial);
    const NewtonIteration iteration = newton.parameters.iteration;
    Attempt               attempt   = iterate(run, trial, iteration, true);
    if (attempt.result.failed() && iteration == NewtonIteration::mixed)
      {
        out << "  not converged: " << attempt.result.failure.message
            << "; trying the substituted iteration" << std::endl;
        const unsigned int spent = attempt.result.iterations;
        // the secant may be misleading; the coarser mesh has a solution
        attempt = iterate(run, trial, NewtonIteration::substituted, false);
        attempt.result.iterations += spent;
      }
    // another branch may be found, so that halving comes first
    if (attempt.result.failed() && run.rolls && run.friction &&
        !run.control.can_cut())
      return try_gentle_friction(run, trial, attempt);
    return attempt;
  }


  LoadStepping::Attempt
  LoadStepping::try_gentle_friction(const StageRun       &run,
                                    const Control::Trial &trial,
                                    const Attempt        &failed)
  {
    // of the speed: nearly viscous friction
    constexpr double       gentle       = 0.25;
    constexpr unsigned int max_attempts = 16;

    out << "  not converged: " << failed.result.failure.message
        << "; trying larger critical velocities" << std::endl;
    StageRun     gentle_run = run;
    Attempt      reached    = failed;
    unsigned int iterations = failed.result.iterations;
    reached.state           = run.state;
    reached.mu              = trial.mu;

    const double given    = run.friction->critical_velocity;
    const double speed    = std::abs(trial.level(trial.mu).ground_velocity);
    double       velocity = std::max(gentle * speed, 256 * given), ratio = 4;
    std::optional<double> last;
    for (unsigned int i = 0; i < max_attempts; ++i)
      {
        out << "  critical velocity " << velocity << std::endl;
        gentle_run.friction = std::make_shared<const FrictionLaw>(
          run.friction->with_critical_velocity(velocity));
        Attempt attempt = converge(gentle_run,
                                   trial,
                                   reached.state,
                                   reached.mu,
                                   newton.parameters.iteration,
                                   false);
        iterations += attempt.result.iterations;
        attempt.result.iterations = iterations;
        if (attempt.result.stopped ||
            (attempt.result.converged && velocity == given))
          return attempt;
        if (attempt.result.converged)
          {
            reached = attempt;
            last    = velocity;
          }
        else if (last)
          ratio = std::sqrt(ratio);
        else
          break;
        velocity = std::max(given, *last / ratio);
      }
    reached                   = failed;
    reached.result.iterations = iterations;
    return reached;
  }


  LoadStepping::Attempt
  LoadStepping::iterate(const StageRun       &run,
                        const Control::Trial &trial,
                        const NewtonIteration iteration,
                        const bool            secant)
  {
    Attempt attempt;
    attempt.state = run.state;
    attempt.mu    = trial.mu;

    const Progress &progress = run.progress;
    const Instant   from{progress.stage, run.control.done()};
    const Instant   to{from.stage, from.fraction + trial.size};
    const bool      zone_given =
      trial.size > 0 && nested != nullptr &&
      nested->predict(equations.mesh, from, to, attempt.state);
    if (trial.size > 0 && !zone_given && secant && parameters.predict)
      progress.predictor.predict(attempt.state, attempt.mu, trial.size);

    return converge(
      run, trial, attempt.state, attempt.mu, iteration, zone_given);
  }


  LoadStepping::Attempt
  LoadStepping::converge(const StageRun       &run,
                         const Control::Trial &trial,
                         const State          &guess,
                         const LoadParameters &mu,
                         const NewtonIteration iteration,
                         const bool            zone_given)
  {
    Attempt attempt;
    attempt.state = guess;
    attempt.mu    = mu;

    std::optional<Gas::Sealed> sealed;
    if (run.progress.gas_content)
      sealed.emplace(*gas, *run.progress.gas_content);
    const ParametrizedLoads loads{
      [&](const LoadParameters &mu) { return loads_at(trial.level(mu), run); },
      trial.equations.get(),
      sealed ? &*sealed : nullptr};
    attempt.result =
      newton.solve(attempt.state, loads, attempt.mu, iteration, zone_given);
    attempt.level = trial.level(attempt.mu);
    return attempt;
  }


  std::optional<unsigned int>
  LoadStepping::negative_pivots(const StageRun &run, const Attempt &attempt)
  {
    if (run.stage.critical_points == CriticalPoints::ignore ||
        run.stage.sealed || run.stage.theory == StrainTheory::linear)
      return {};
    if (!run.stage.locates_critical_points())
      return attempt.result.n_negative_pivots;
    Assert(buckling_analysis, ExcNotInitialized());
    const auto n = buckling_analysis->count_negative_pivots(
      {attempt.state, loads_at(attempt.level, run)});
    if (!n && !warned_of_critical_points)
      {
        out << "  Warning: critical points of " << run.stage.name
            << " cannot be found: the tangent is not symmetric, as with loads "
               "without a potential, or the linear solver does not count "
               "negative pivots"
            << std::endl;
        warned_of_critical_points = true;
      }
    return n;
  }


  double
  LoadStepping::bisect(const StageRun              &run,
                       Control::Trial              &trial,
                       Attempt                     &attempt,
                       std::optional<unsigned int> &n_negative)
  {
    // of the loads, and of the step, since loads do not tell at a limit point
    constexpr double       tolerance = 1e-3, maximum_part = 0.05;
    constexpr unsigned int max_bisections = 40;

    const std::optional<unsigned int> n_before = run.progress.n_negative_pivots;
    LoadLevel                         level_before = run.progress.reached;
    double                            low = 0, high = 1, taken = 1;
    for (unsigned int i = 0; i < max_bisections; ++i)
      {
        if (relative_change(level_before, attempt.level) <= tolerance &&
            high - low <= maximum_part)
          break;
        const double middle = (low + high) / 2;
        run.control.scale_step(middle / taken);
        taken                      = middle;
        const Control::Trial other = run.control.propose(last_converged(run));
        out << "  bisection for a critical point" << std::endl;
        Attempt half = try_step(run, other);
        if (half.result.stopped)
          {
            attempt = half;
            return high;
          }
        half.result.iterations += attempt.result.iterations;
        const std::optional<unsigned int> n =
          (half.result.converged ? negative_pivots(run, half) : std::nullopt);
        if (!n)
          {
            attempt.result.iterations = half.result.iterations;
            break;
          }
        if (*n == *n_before)
          {
            low                       = middle;
            level_before              = half.level;
            attempt.result.iterations = half.result.iterations;
          }
        else
          {
            high       = middle;
            trial      = other;
            attempt    = half;
            n_negative = n;
          }
      }
    run.control.scale_step(high / taken);
    return high;
  }


  namespace
  {
    /** The change of the loads from one level to another, without those that do
     * not make a shell buckle. */
    LoadRates
    change_of(const LoadLevel &before, const LoadLevel &after)
    {
      LoadRates change;
      change.pressure = after.pressure - before.pressure;
      change.factor   = after.factor - before.factor;
      change.travel   = after.travel - before.travel;
      return change;
    }
  } // namespace


  std::shared_ptr<const CriticalPoint>
  LoadStepping::critical_point(const StageRun    &run,
                               const LoadLevel   &level_before,
                               const unsigned int n_before,
                               const unsigned int n_after,
                               const bool         located)
  {
    Assert(buckling_analysis, ExcNotInitialized());
    out << "  negative pivots: " << n_after << " after " << n_before;
    const LoadLevel   &level = run.progress.reached;
    const unsigned int n_changed =
      std::max(n_after, n_before) - std::min(n_after, n_before);
    const bool several = !located && n_changed > BucklingAnalysis::n_candidates;
    const auto mode =
      (several
         ? std::nullopt
         : buckling_analysis->critical_mode({run.state, loads_at(level, run)},
                                            change_of(level_before, level),
                                            n_after > n_before));
    if (!mode)
      {
        out << (several ? ", the step passed several critical points" : "")
            << std::endl;
        return nullptr;
      }

    auto point               = std::make_shared<CriticalPoint>();
    point->n_negative_before = n_before;
    point->n_negative_after  = n_after;
    point->located           = located;
    point->mode              = *mode;
    const LoadLevel &start   = run.progress.control.start;
    point->loads = {part_of_loads(start, level, run.stage.end(start)), level};
    out << ", " << (located ? "here is a " : "the step passed a ")
        << point->kind() << std::endl;
    if (run.stage.critical_points == CriticalPoints::switch_branch &&
        !point->is_limit_point())
      run.progress.branch = owned_part(point->mode.shape);
    return point;
  }


  std::optional<LoadStepping::Attempt>
  LoadStepping::try_branch(const StageRun &run, Control::Trial &trial)
  {
    constexpr unsigned int max_attempts = 40, max_cuts = 6;

    const bool        to_given_loads = (trial.equations == nullptr);
    const double      target         = trial.mu[0];
    const LA::Vector &shape          = run.progress.branch;
    const auto        fail           = [&](const std::string &why) {
      out << "  the other branch was not found: " << why << "; the path goes on"
          << std::endl;
      return std::nullopt;
    };

    announce(run, trial);
    Control::Trial along = trial;
    along.size           = 0;
    Attempt reached;
    reached.state           = run.state;
    reached.mu              = {run.control.done()};
    unsigned int iterations = 0, n_cuts = 0;
    double       amplitude = 0;
    double increment = run.stage.branch_amplitude * equations.mesh.thickness();
    for (unsigned int i = 0; i < max_attempts; ++i)
      {
        out << "  to the other branch, largest displacement in the critical "
               "shape "
            << amplitude + increment << std::endl;
        along.equations = std::make_shared<const ShapeEquation>(
          run.control.load_rate(), shape, amplitude + increment);
        State      guess = reached.state;
        LA::Vector change(shape);
        change *= increment;
        equations.update(guess, change, NewtonIteration::substituted);
        const Attempt attempt =
          converge(run, along, guess, reached.mu, newton.parameters.iteration);
        iterations += attempt.result.iterations;
        if (attempt.result.stopped)
          return attempt;
        if (!attempt.result.converged)
          {
            if (++n_cuts > max_cuts)
              return fail(attempt.result.failure.message);
            increment /= 2;
            continue;
          }
        reached = attempt;
        amplitude += increment;
        if (!to_given_loads || reached.mu[0] >= target)
          break;
        if (n_cuts == 0)
          increment = amplitude;
      }
    if (to_given_loads)
      {
        if (reached.mu[0] < target)
          return fail("it does not reach the loads of the next step");
        reached = converge(
          run, trial, reached.state, trial.mu, newton.parameters.iteration);
        iterations += reached.result.iterations;
        if (!reached.result.converged && !reached.result.stopped)
          return fail(reached.result.failure.message);
      }
    else
      trial = along;
    reached.result.iterations = iterations;
    reached.to_branch         = true;
    return reached;
  }


  StepReport
  LoadStepping::accept(const StageRun       &run,
                       const Control::Trial &trial,
                       Attempt              &attempt)
  {
    const NewtonResult   &result   = attempt.result;
    Progress             &progress = run.progress;
    const Control::Memory memory   = run.control.get_memory();
    const LoadLevel       level    = trial.level(attempt.mu);
    run.control.accept({trial,
                        attempt.mu,
                        result.iterations,
                        run.state,
                        attempt.state,
                        attempt.to_branch});
    if (attempt.to_branch)
      progress.predictor.reset();
    else if (trial.size > 0)
      {
        LoadParameters change = attempt.mu;
        add(change, -1, trial.mu);
        progress.predictor.learn(run.state, attempt.state, change, trial.size);
      }
    progress.last_change = owned_part(attempt.state.displacement);
    progress.last_change -= owned_part(run.state.displacement);
    const Loads before = loads_at(progress.reached, run);
    progress.reached   = level;
    if (progress.gas_content)
      progress.reached.pressure =
        Gas::Sealed(*gas, *progress.gas_content).pressure(attempt.state);
    const Loads now = loads_at(progress.reached, run);
    if (follower)
      follower->follow({run.stage,
                        progress.stage,
                        memory,
                        trial,
                        attempt.mu,
                        attempt.state,
                        now,
                        run.control.done() >= 1});
    contact.record_history(attempt.state, now);
    if (!run.forces)
      run.forces = std::make_shared<const NodalForces>(
        equations.nodal_forces(run.state, before));
    const auto forces = std::make_shared<const NodalForces>(
      equations.nodal_forces(attempt.state, now));
    progress.work += work_of_step(
      contact, {run.state, before, *run.forces}, {attempt.state, now, *forces});
    run.forces       = forces;
    run.state        = attempt.state;
    progress.control = run.control.get_memory();
    ++progress.n_steps;

    StepReport report;
    report.step       = progress.n_steps;
    report.instant    = {progress.stage, run.control.done()};
    report.stage      = run.stage.name;
    report.in_contact = run.stage.contact;
    report.loads      = now;
    report.approach   = (run.stage.contact ? progress.reached.travel : 0.);
    report.work       = progress.work;
    report.level      = progress.reached;
    if (run.stage.contact)
      {
        report.slide = progress.reached.slide;
        report.turn  = progress.reached.turn;
      }
    report.contact    = contact.summarize(run.state, report.loads);
    report.footprint  = find_footprint(contact, run.state, report.loads);
    report.forces     = forces;
    report.controlled = run.control.controlled();
    const std::optional<FoundationReaction> reaction_before = progress.reaction;
    progress.reaction.reset();
    if (run.stage.contact)
      {
        const ForceOnShell now =
          force_of_foundation(equations, run.state, *forces, Point<3>());
        progress.reaction = {progress.reached, now.force, now.moment};
        report.stiffness  = stiffness(run, reaction_before);
        if (report.loads.rolling)
          {
            report.rolling = summarize_rolling(
              equations, contact, run.state, report.loads, *forces);
            if (progress.free_rolling_radius)
              report.slip_ratio =
                slip_ratio(progress.reached, *progress.free_rolling_radius);
          }
        warn_of_pierced_nodes(run.state, report.loads);
      }
    report.iterations        = result.iterations;
    report.residuals         = result.residuals;
    report.n_negative_pivots = result.n_negative_pivots;
    warn_of_fast_wheel(report);
    return report;
  }


  std::optional<StepStiffness>
  LoadStepping::stiffness(const StageRun                          &run,
                          const std::optional<FoundationReaction> &before) const
  {
    const Progress &progress = run.progress;
    const auto     &first    = progress.first_reaction;
    if (!first || !before)
      return {};
    const LoadLevel &now = progress.reaction->level;
    // the pressure of a sealed gas follows from the motion
    if (now.factor != first->level.factor ||
        (now.pressure != first->level.pressure && !run.stage.sealed))
      return {};

    const Tensor<1, 3> outward = contact.foundation(0).direction();
    const Point<3>     center  = progress.touched_point + first->level.slide -
                            first->level.travel * outward;
    const auto secant =
      foundation_stiffness(*first, *progress.reaction, outward, center);
    const auto tangent =
      foundation_stiffness(*before, *progress.reaction, outward, center);
    if (!secant || !tangent)
      return {};
    return StepStiffness{*first, *secant, *tangent};
  }


  bool
  LoadStepping::wants_left_eigenvectors(const StageRun &run) const
  {
    return follower && follower->reads_left_eigenvectors(run.progress.stage);
  }


  std::shared_ptr<const VibrationModes>
  LoadStepping::find_modes(const StageRun &run, const Loads &loads)
  {
    Assert(modal_analysis, ExcNotInitialized());
    std::optional<Gas::Sealed> sealed;
    if (run.progress.gas_content)
      sealed.emplace(*gas, *run.progress.gas_content);
    auto modes = std::make_shared<const VibrationModes>(
      modal_analysis->compute(run.state,
                              loads,
                              sealed ? &*sealed : nullptr,
                              run.stage.n_modes,
                              wants_left_eigenvectors(run)));
    if (!modes->success)
      {
        out << "  Warning: the modes of " << run.stage.name
            << " were not found: " << modes->message << std::endl;
        return nullptr;
      }
    out << "  frequencies:";
    for (const VibrationMode &mode : modes->modes)
      out << ' ' << mode.frequency();
    out << std::endl;
    return modes;
  }


  std::shared_ptr<const Buckling>
  LoadStepping::find_buckling(const StageRun           &run,
                              const EarlierEquilibrium &before_step)
  {
    Assert(buckling_analysis, ExcNotInitialized());
    const LoadLevel    &start = run.progress.control.start;
    const LoadLevel    &level = run.progress.reached;
    const BucklingStart before =
      buckling_start(equations.internal_forces(),
                     start,
                     before_step,
                     [&](const LoadLevel &of) { return loads_at(of, run); });
    const Loads loads  = loads_at(level, run);
    LoadRates   change = change_of(before.level, level);
    if (run.stage.sealed)
      change.pressure = 0;
    const BucklingModes found =
      buckling_analysis->compute({before.state, before.loads},
                                 {run.state, loads},
                                 run.stage.sealed ? gas : nullptr,
                                 change,
                                 run.stage.n_buckling,
                                 wants_left_eigenvectors(run));
    if (!found.success)
      {
        out << "  Warning: the buckling loads of " << run.stage.name
            << " were not found: " << found.message << std::endl;
        return nullptr;
      }
    auto buckling = std::make_shared<const Buckling>(
      buckling_from(found, start, before.level, level, run.stage.sealed));
    if (buckling->modes.empty())
      {
        out << "  no buckling is predicted for this change of the loads"
            << std::endl;
        return nullptr;
      }
    out << "  buckling at factors of the loads of the stage:";
    for (const CriticalLoads &critical : buckling->loads)
      out << ' ' << critical.factor;
    out << std::endl;
    return buckling;
  }


  void
  LoadStepping::warn_of_pierced_nodes(const State &state, const Loads &loads)
  {
    if (warned_of_pierced_nodes)
      return;
    const ActiveSet pierced = contact.pierced_nodes(state, loads);
    const bool      any     = std::any_of(
      pierced.begin(), pierced.end(), [](const char node) { return node; });
    if (!Utilities::MPI::logical_or(any, contact.mesh.communicator))
      return;
    out << "  Warning: the foundation penetrates supported nodes, which "
           "cannot come into contact: "
        << name_nodes(contact.mesh, pierced) << std::endl;
    warned_of_pierced_nodes = true;
  }


  void
  LoadStepping::warn_of_fast_wheel(const StepReport &report)
  {
    const auto &strips = contact.mesh.strips;
    if (warned_of_fast_wheel || report.n_negative_pivots.value_or(0) == 0 ||
        !report.loads.rolling || report.loads.rolling->angular_velocity == 0 ||
        std::none_of(strips.begin(), strips.end(), [](const Strip &strip) {
          return strip.laminate.mass_moments()[0][0] > 0;
        }))
      return;
    const std::vector<double> &lines = contact.mesh.grid.lines[1];
    double                     angle = 0;
    for (std::size_t i = 1; i < lines.size(); ++i)
      angle = std::max(angle, lines[i] - lines[i - 1]);
    out << "  Warning: the tangent has negative pivots at the angular velocity "
        << number_to_string(report.loads.rolling->angular_velocity)
        << ". Either the wheel is so fast that waves stand in it, or its "
           "cells, of up to "
        << number_to_string(std::round(angle * 180 / numbers::PI))
        << " degrees around the axle, are too large for its inertia: compare "
           "with cells of half the angle."
        << std::endl;
    warned_of_fast_wheel = true;
  }


  Control::Equilibrium
  LoadStepping::last_converged(const StageRun &run) const
  {
    return {
      equations,
      contact,
      run.state,
      run.progress.reached,
      run.progress.last_change,
      [this, &run](const LoadLevel &level) { return loads_at(level, run); }};
  }


  Loads
  LoadStepping::loads_at(const LoadLevel &level, const StageRun &run) const
  {
    return Biface::loads_at(
      level, run.stage, run.rolls, run.friction, contact, run.progress);
  }
} // namespace Biface
