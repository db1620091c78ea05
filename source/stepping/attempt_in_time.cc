// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <biface/input/parameter_tools.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/settle_friction.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/time/axle_moment_in_time.h>
#include <biface/model/time/energy_of_motion.h>
#include <biface/stepping/attempt_in_time.h>
#include <biface/stepping/masses_of_stage.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/start_motion.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The loads of which the step takes the value in its middle. */
    std::vector<double>
    loads_of(const LoadLevel &level)
    {
      std::vector<double> loads = level.factors;
      loads.insert(loads.end(),
                   {level.pressure,
                    level.angular_velocity,
                    level.ground_velocity,
                    level.slip_angle});
      return loads;
    }


    /** Whether the value of a load in the middle of a step is not its mean in
     * the step. */
    bool
    loads_change_unevenly(const Control::Trial &trial, const LoadLevel &middle)
    {
      // of the largest value in the step
      constexpr double remarkable = 0.1;

      const QGauss<1>           rule(8);
      const std::vector<double> at_middle = loads_of(middle);
      std::vector<double> mean(at_middle.size()), largest(at_middle.size());
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const std::vector<double> loads =
            loads_of(trial.within(rule.point(q)[0]));
          for (unsigned int i = 0; i < loads.size(); ++i)
            {
              mean[i] += rule.weight(q) * loads[i];
              largest[i] = std::max(largest[i], std::abs(loads[i]));
            }
        }
      for (unsigned int i = 0; i < mean.size(); ++i)
        if (!(std::abs(mean[i] - at_middle[i]) <= remarkable * largest[i]))
          return true;
      return false;
    }
  } // namespace


  namespace
  {
    /** See StepInTime::of_supports: the velocity at the end of the step follows
     * from the places of the supports at its start, in its middle and at its
     * end; by the mean velocity alone it would alternate from step to step
     * where the velocity changes. Supports that masses move are unknowns.
     * @param middle, end with the factors of masses at the start. */
    LA::Vector
    correction_by_supports(const StageRun   &run,
                           const StepInTime &step,
                           const LoadLevel  &middle,
                           const LoadLevel  &end)
    {
      const ShellMesh &mesh = run.equations.mesh;
      if (!mesh.prescribes_displacements())
        return {};
      const MotionOfSupports motion(run.equations,
                                    run.state,
                                    {step.loads_at_start,
                                     run.loads_at(middle),
                                     run.loads_at(end),
                                     step.duration});
      LA::Vector             correction = mesh.owned_vector();
      for (const PrescribedDisplacement &p : mesh.prescribed)
        if (mesh.locally_owned.is_element(p.dof))
          // the rule of the step would end at 2 v_mean - v_0
          correction(p.dof) =
            (motion.at_end(p.dof) -
             (2 * motion.mean(p.dof) - (run.state.velocity(p.dof) -
                                        velocity_by_masses(p, step.masses)))) /
            step.duration;
      correction.compress(VectorOperation::insert);
      mesh.constraints.distribute(correction);
      LA::Vector result = mesh.ghosted_vector();
      result            = correction;
      return result;
    }
  } // namespace


  namespace
  {
    /** The forces that a guess leaves without balance. */
    double
    out_of_balance(const StageRun       &run,
                   const Control::Trial &trial,
                   const LoadParameters &mu,
                   State                 guess)
    {
      const Loads loads = run.equations.with_dependent_loads(
        guess, run.loads_at(trial.level(mu)));
      run.equations.move_supports(guess, loads);
      return run.equations.out_of_balance_forces(guess, loads).l2_norm();
    }


    /** Set the initial guess of a step: the shell moves on with its velocity
     * or, if that leaves larger forces without balance, as in a step in which
     * vibrations come and go, it stays where it is. */
    void
    set_guess(const StageRun       &run,
              const Control::Trial &trial,
              Attempt              &attempt)
    {
      const StepInTime &step = *attempt.state.step;
      LoadParameters    mu   = attempt.mu;
      for (unsigned int i = 0; i < step.masses.size(); ++i)
        mu[i] +=
          step.duration * step.masses[i].velocity / step.masses[i].amplitude;
      State moved = attempt.state;
      // a temporary would be moved, without the entries of ghosts
      const LA::Vector displacement = extrapolated(run.state, step.duration);
      moved.displacement            = displacement;
      if (out_of_balance(run, trial, attempt.mu, attempt.state) <
          out_of_balance(run, trial, mu, moved))
        return;
      attempt.state.displacement = displacement;
      attempt.mu                 = mu;
      attempt.level              = trial.level(mu);
    }
  } // namespace


  Attempt
  attempt_step_in_time(Newton               &newton,
                       const StageRun       &run,
                       const Control::Trial &trial)
  {
    const auto step         = std::make_shared<StepInTime>();
    step->start             = run.state;
    step->loads_at_start    = run.loads_at(run.progress.reached);
    step->duration          = trial.within(1).time - run.progress.reached.time;
    step->damping           = run.stage.damping_in_time;
    step->moment_of_inertia = run.stage.moment_of_inertia;
    step->masses            = masses_of_stage(run.stage,
                                   run.equations.mesh,
                                   run.state,
                                   step->loads_at_start,
                                   step->duration);
    const LoadLevel middle  = trial.within(0.5);
    step->middle.pressure   = middle.pressure;
    step->middle.factors    = middle.factors;

    Attempt attempt;
    attempt.mu        = trial.mu;
    attempt.level     = trial.level(trial.mu);
    const auto reject = [&attempt](const std::string &why, const double error) {
      attempt.result.converged = false;
      attempt.result.failure   = {FailureCause::error_in_time, why};
      attempt.error_in_time    = error;
    };
    // where the error is not known, of a step that becomes half as long
    const double too_large = 4 * run.stage.time_error;
    if (run.stage.time_error > 0 && loads_change_unevenly(trial, middle))
      {
        reject("the loads change too unevenly in the step", too_large);
        return attempt;
      }
    step->of_supports =
      correction_by_supports(run, *step, middle, trial.within(1));
    attempt.state              = run.state;
    attempt.state.step         = step;
    attempt.state.time_step    = run.time_step_to(attempt.level);
    attempt.state.rolling_step = run.rolling_step(step->duration);
    set_guess(run, trial, attempt);

    const ParametrizedLoads given{
      [&](const LoadParameters &mu) { return run.loads_at(trial.level(mu)); },
      trial.equations.get()};
    NewtonResult        &result      = attempt.result;
    const State          start       = attempt.state;
    const LoadParameters guess_of_mu = attempt.mu;
    result                           = newton.solve(
      attempt.state, given, attempt.mu, NewtonIteration::substituted);
    if (result.failed() &&
        run.contact.has_friction(run.loads_at(attempt.level)) && !run.rolls)
      {
        // near the solution the exact tangent converges
        const auto secant          = std::make_shared<StepInTime>(*step);
        secant->secant_of_friction = true;
        unsigned int spent         = result.iterations;
        attempt.state              = start;
        for (const auto &with : {secant, step})
          if (result.failed())
            {
              attempt.mu         = guess_of_mu;
              attempt.state.step = with;
              result             = newton.solve(
                attempt.state, given, attempt.mu, NewtonIteration::substituted);
              spent += result.iterations;
            }
        result.iterations  = spent;
        attempt.state.step = step;
      }
    // those of the tangent with inertia say nothing about an equilibrium
    result.n_negative_pivots.reset();
    if (!result.converged)
      return attempt;

    attempt.level     = trial.level(attempt.mu);
    const Loads loads = run.loads_at(attempt.level);
    run.contact.settle(attempt.state, loads);
    std::string passed = run.contact.passed_body(
      run.state, step->loads_at_start, attempt.state, loads);
    // in time the shell may also jump over the ground
    const ContactPair &ground = run.contact.ground();
    if (ground.body(loads) && ground.body(step->loads_at_start) &&
        Utilities::MPI::logical_or(
          was_passed(
            ground, run.state, step->loads_at_start, attempt.state, loads),
          run.equations.mesh.communicator))
      passed = ground.name;
    if (!passed.empty())
      {
        result.converged = false;
        result.failure   = {FailureCause::other_solution,
                            "the shell has passed through the body '" + passed +
                              "' in one step"};
        return attempt;
      }
    if (run.stage.time_error == 0)
      return attempt;
    // steps whose error is twice the one that is wanted count as well
    constexpr double  largest = 2;
    const ErrorInTime error =
      error_in_time(run.equations, attempt.state, loads);
    // the first accelerations of a shell at rest have none before them with
    // which they could be compared
    constexpr double first_part = 1e-3;
    if (error.from_rest)
      {
        if (trial.size > first_part * (1 + 1e-6))
          reject("a motion begins in the step", too_large);
      }
    else if (error.value <= largest * run.stage.time_error)
      attempt.error_in_time = error.value;
    else
      reject("the step is too long: its error in time is " +
               number_to_string(error.value),
             error.value);
    return attempt;
  }


  std::shared_ptr<const NodalForces>
  forces_over_step(const StageRun &run, const Attempt &attempt)
  {
    return std::make_shared<const NodalForces>(run.equations.nodal_forces(
      attempt.state,
      run.equations.with_dependent_loads(attempt.state,
                                         run.loads_at(attempt.level))));
  }


  EndOfStepInTime
  end_step_in_time(const StageRun                          &run,
                   const std::shared_ptr<const StepInTime> &step,
                   const Loads                             &loads,
                   const NodalForces                       &forces,
                   State                                   &state)
  {
    const LA::Vector velocity = step->velocity(state);
    state.velocity            = run.equations.mesh.ghosted_vector();
    state.velocity            = velocity;
    state.step                = step;
    for (const auto &pair : run.contact.pairs)
      settle_friction_over_step(*pair, loads, state);
    remember_motion(run.equations, loads, state);
    const EnergyOfMotion energy =
      energy_of_motion(run.equations, run.contact, state, loads);
    const Work work =
      work_in_time(run.equations, run.contact, state, loads, forces, energy);
    std::optional<double> moment;
    if (loads.rolling)
      moment = axle_moment_in_time(run.contact, state, loads).value;
    state.step.reset();
    return {work, energy, moment};
  }
} // namespace Biface
