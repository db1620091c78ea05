// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

#include <biface/analysis/sensitivity_analysis.h>
#include <biface/base/errors.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/footprint.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/solver/low_rank_stiffness.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/buckling_start.h>
#include <biface/stepping/sensitivity_table.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_reporting.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Refuse a changed mesh whose unknowns are not those of the run. */
    void
    check_mesh(const ShellMesh   &mesh,
               const ShellMesh   &changed,
               const std::string &name)
    {
      bool same =
        mesh.n_nodes() == changed.n_nodes() &&
        mesh.cells.size() == changed.cells.size() &&
        mesh.nodes.size() == changed.nodes.size() &&
        mesh.locally_relevant == changed.locally_relevant &&
        mesh.constraints.n_constraints() == changed.constraints.n_constraints();
      for (unsigned int n = 0; same && n < mesh.nodes.size(); ++n)
        same = mesh.nodes[n].dofs == changed.nodes[n].dofs &&
               mesh.nodes[n].number == changed.nodes[n].number &&
               mesh.nodes[n].face_is_free == changed.nodes[n].face_is_free;
      // all ranks refuse or none, wherever the nodes differ
      if (Utilities::MPI::min(static_cast<unsigned int>(same),
                              mesh.communicator) == 0)
        throw InputError("Sensitivities/Entries",
                         name,
                         "a small change of it must not change the nodes of "
                         "the mesh");
    }


    /** Whether three values at equal distances are on a straight line: whether
     * the second deviates from the mean of the others by no more than a part of
     * their difference.
     * @param roundoff a deviation that does not count. */
    bool
    is_straight(const double below,
                const double here,
                const double above,
                const double roundoff)
    {
      constexpr double smooth = 0.05;

      return !(std::abs((above + below) / 2 - here) >
               smooth * std::abs(above - below) + roundoff);
    }


    /** The stages at whose ends derivatives are wanted. */
    std::vector<Stage>
    wanted_stages(const Parameters &parameters)
    {
      std::vector<Stage> wanted;
      for (unsigned int s = 0; s < parameters.stages.size(); ++s)
        if (parameters.sensitivities.is_wanted(s, parameters.stages.size()))
          wanted.push_back(parameters.stages[s]);
      return wanted;
    }


    /** The results of which derivatives are computed, of a run with the given
     * parameters. */
    ScalarResults
    asked_results(const Parameters &parameters, const ShellModel &model)
    {
      return {"Sensitivities/Outputs",
              parameters.sensitivities.outputs,
              model.equations,
              parameters.output.criteria,
              parameters.output.forces.moment_center,
              ScalarResults::Known::at_ends(model.cavity.get(),
                                            wanted_stages(parameters)),
              ScalarResults::Columns::differentiable};
    }


    bool
    are_finite(const std::vector<double> &values)
    {
      return std::all_of(values.begin(), values.end(), [](const double value) {
        return std::isfinite(value);
      });
    }


    /** The forces on the nodes, with those of the ground, or of another
     * body where it is not in contact, that balance the others: stiff contact
     * makes the round-off of positions large, but equilibrium is known. */
    NodalForces
    forces_in_equilibrium(const ShellModel &model,
                          const State      &state,
                          const Loads      &loads)
    {
      const ShellMesh &mesh   = *model.mesh;
      NodalForces      forces = model.equations.nodal_forces(state, loads);
      LA::Vector       sum    = forces[ForceTerm::Source::ground];
      sum += forces[ForceTerm::Source::shell];
      sum += forces[ForceTerm::Source::loads];
      for (const auto &[name, of_body] : forces.of_bodies)
        sum += of_body;
      // forces on constrained unknowns act on those that they follow
      mesh.condense(sum);
      ActiveSet balanced(mesh.nodes.size(), 0);
      for (const auto &pair : model.contact.pairs)
        {
          LA::Vector     &of_pair = (pair.get() == &model.contact.ground()
                                       ? forces[ForceTerm::Source::ground]
                                       : forces.of_bodies.at(pair->name));
          const ActiveSet in_contact =
            pair->points.nodes_around(pair->state_of(state).active);
          for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
            if (mesh.nodes[n].locally_owned && !balanced[n] && in_contact[n])
              {
                // what is missing at a node is balanced once, by one of the
                // bodies that it touches
                balanced[n] = 1;
                for (const auto dof : mesh.nodes[n].dofs)
                  if (!mesh.constraints.is_constrained(dof))
                    of_pair(dof) -= sum(dof);
              }
          of_pair.compress(VectorOperation::add);
        }
      return forces;
    }


    /** The change of the displacements between two states. */
    LA::Vector
    change(const State &before, const State &after)
    {
      LA::Vector result = owned_part(after.displacement);
      result -= owned_part(before.displacement);
      return result;
    }


    /** Give a state the contact multipliers of another one. */
    void
    take_multipliers(const State &from, State &to)
    {
      for (unsigned int i = 0; i < to.contacts.size(); ++i)
        to.contacts[i].multipliers = from.contacts[i].multipliers;
    }
  } // namespace


  /** A run with a changed entry. */
  struct SensitivityAnalysis::PerturbedRun
  {
    PerturbedRun(std::shared_ptr<const Parameters> given,
                 std::shared_ptr<const ShellMesh>  mesh)
      : parameters(std::move(given))
      , model(*parameters, std::move(mesh))
      , results(asked_results(*parameters, model))
      , state(model.contact.unloaded_state())
    {}

    RestorePoint
    restore_point() const
    {
      return {state, progress};
    }

    void
    restore(const RestorePoint &point)
    {
      state    = point.state;
      progress = point.progress;
    }

    /** Enter the current stage of the progress. */
    void
    enter_stage()
    {
      run = std::make_unique<StageRun>(parameters->stages,
                                       parameters->load_stepping.control,
                                       model.equations,
                                       model.contact,
                                       model.heat.get(),
                                       progress,
                                       state);
    }

    const std::shared_ptr<const Parameters> parameters;
    ShellModel                              model;
    const ScalarResults                     results;
    State                                   state;
    Progress                                progress;
    StageEnds                               ends;
    /** The current stage. */
    std::unique_ptr<StageRun> run;

    /** What moves in an equilibrium of the current stage. */
    MovingReactions
    reactions(const State &state, const LoadLevel &level) const
    {
      Loads loads = run->loads_at(level);
      // that of a sealed gas may have changed since
      loads.pressure = level.pressure;
      return moving_reactions(
        model.equations,
        level,
        loads,
        forces_on_shell(
          model.equations, state, forces_in_equilibrium(model, state, loads)));
    }

    /** The step that is followed: its loads, and the state before it. */
    Control::Trial trial;
    LoadLevel      level;
    Loads          loads;
    State          before;
    LoadLevel      level_before;

    /** How it deviates from the run at the end of this step. */
    struct Deviation
    {
      LA::Vector     displacements;
      LoadParameters mu;
    };
    Deviation deviation;
    /** The deviation for which the forces were evaluated last. The round-off in
     * the positions is balanced by the displacements since. */
    Deviation balanced;
    /** The displacements of the run, but at the supports its own. */
    LA::Vector fixed;

    /** The displacements for which the forces were evaluated last. */
    LA::Vector
    balanced_displacements() const
    {
      LA::Vector result = fixed;
      result += balanced.displacements;
      return result;
    }

    /** The displacements since. */
    LA::Vector
    since_balanced() const
    {
      LA::Vector result = deviation.displacements;
      result -= balanced.displacements;
      return result;
    }
  };


  SensitivityAnalysis::SensitivityAnalysis(const Parameters   &parameters,
                                           ShellModel         &model,
                                           LinearSolver       &linear_solver,
                                           ConditionalOStream &out,
                                           TimerOutput        &timer)
    : parameters(parameters)
    , model(model)
    , linear_solver(linear_solver)
    , out(out)
    , timer(timer)
    , results(asked_results(parameters, model))
  {
    TimerOutput::Scope scope(timer, "Sensitivities");
    for (const Change &change : parameters.sensitivities.changes)
      for (const auto &changed : change.parameters)
        {
          using MeshChange = SensitivityParameters::MeshChange;
          std::shared_ptr<const ShellMesh> mesh = model.mesh;
          if (change.mesh_change != MeshChange::nothing)
            {
              mesh = (change.mesh_change == MeshChange::plies
                        ? with_other_plies(*mesh, *changed)
                        : make_shell_mesh(*changed, mesh->communicator));
              check_mesh(*model.mesh, *mesh, change.name);
            }
          perturbed_runs.push_back(
            std::make_unique<PerturbedRun>(changed, mesh));
        }
  }


  SensitivityAnalysis::~SensitivityAnalysis() = default;


  PerturbedPoints
  SensitivityAnalysis::get_restore_points() const
  {
    PerturbedPoints points{{}, lost_stages, unsettled};
    for (const auto &perturbed : perturbed_runs)
      {
        points.runs.push_back({perturbed->restore_point(), perturbed->ends});
        // zeros are not written; they follow from the displacements
        for (Modes::Vector &resultants :
             points.runs.back().last.state.resultants)
          resultants = 0;
      }
    return points;
  }


  void
  SensitivityAnalysis::restore(const PerturbedPoints &points)
  {
    AssertDimension(points.runs.size(), perturbed_runs.size());
    lost_stages = points.lost_stages;
    unsettled   = points.unsettled;
    for (unsigned int i = 0; i < perturbed_runs.size(); ++i)
      {
        PerturbedRun &perturbed = *perturbed_runs[i];
        perturbed.restore(points.runs[i].last);
        // checkpoints do not contain them
        perturbed.model.equations.internal_forces().settle_resultants(
          perturbed.state);
        perturbed.ends = points.runs[i].ends;
        if (perturbed.progress.stage_begun)
          perturbed.enter_stage();
      }
  }


  void
  SensitivityAnalysis::start_stage(const StageRun                    &run,
                                   const std::optional<unsigned int> &before)
  {
    TimerOutput::Scope scope(timer, "Sensitivities");
    const unsigned int stage = run.progress.stage;
    if (before)
      {
        const unsigned int last = stage - 1;
        // the end of the stage before, as LoadStepping::run() keeps that of the
        // run
        if (is_branched_from(parameters.stages, last) &&
            lost_stages.count(last) == 0)
          for (const auto &perturbed : followers(last))
            {
              RestorePoint end     = perturbed->restore_point();
              end.progress.control = Control::Memory();
              perturbed->ends.insert_or_assign(last, std::move(end));
            }
        // without a state at the start, nothing can be followed, and what
        // starts from here is lost, too
        if (lost_stages.count(*before) > 0)
          {
            lost_stages.insert(stage);
            return;
          }
        for (unsigned int e = 0; e < parameters.sensitivities.changes.size();
             ++e)
          if (unsettled.count({*before, e}) > 0)
            unsettled.insert({stage, e});
        if (*before != last)
          for (const auto &perturbed : followers(stage))
            perturbed->restore(perturbed->ends.at(*before));
      }
    for (const auto &perturbed : followers(stage))
      {
        perturbed->progress.stage       = stage;
        perturbed->progress.stage_begun = false;
        perturbed->enter_stage();
        perturbed->run->start();
        // which no steps of its own have left
        if (before && results.have_stiffness())
          perturbed->progress.first_reactions =
            perturbed->reactions(perturbed->state, perturbed->progress.reached);
      }
  }


  std::vector<SensitivityAnalysis::PerturbedRun *>
  SensitivityAnalysis::followers(const unsigned int stage) const
  {
    std::vector<PerturbedRun *> result;
    for (unsigned int i = 0; i < perturbed_runs.size(); ++i)
      if (follows(i / 2, stage))
        result.push_back(perturbed_runs[i].get());
    return result;
  }


  bool
  SensitivityAnalysis::is_read(const Step &step) const
  {
    // the next step reads the histories of friction and of stresses that relax,
    // and the displacements if their change is controlled
    const bool buckles =
      results.have_buckling() && step.run.stage.n_buckling > 0;
    return step.run.is_complete() || model.contact.has_friction(step.loads) ||
           model.mesh->get_layup().relaxes() || step.trial.equations ||
           buckles || results.have_stiffness();
  }


  /** The tangent of the run in a step, with the gas and the load parameter. */
  struct SensitivityAnalysis::Linearization
  {
    Linearization(ShellModel   &model,
                  LinearSolver &linear_solver,
                  const Step   &step)
      : model(model)
      , linear_solver(linear_solver)
      , low_rank(model.equations, step.state, step.loads)
    {
      // assembled for the converged state, whose active set it holds, section
      // 11
      ShellEquations &equations = model.equations;
      equations.assemble(step.state, step.loads);
      check(linear_solver.factorize_for_many(
        equations.tangent(),
        equations.is_symmetric(step.loads, equations.tangent())));
      const bool determined =
        low_rank.prepare([&](LA::Vector &x, const LA::Vector &b) {
          x = solve_with_matrix({b})[0];
          return !failure;
        });
      if (!determined && !failure)
        failure = Failure{FailureCause::singular_tangent,
                          "the pressure of the gas is not determined"};
      if (step.trial.equations && !failure)
        {
          std::vector<EquationSystem::ParameterDirection> directions;
          std::vector<LA::Vector>                         forces;
          // the load parameters are further unknowns, as in section 7
          for (const LoadRates &rates : step.trial.equations->rates)
            {
              directions.push_back(
                equations.parameter_direction(step.state, step.loads, rates));
              forces.push_back(directions.back().forces);
            }
          per_parameter = solve_with_matrix(forces);
          for (unsigned int i = 0; i < directions.size() && !failure; ++i)
            low_rank.complete(per_parameter[i], directions[i]);
        }
    }

    /** The displacements per each of the given forces; those of the supports do
     * not change. */
    std::vector<LA::Vector>
    solve(const std::vector<LA::Vector> &forces)
    {
      std::vector<LA::Vector> solutions = solve_with_matrix(forces);
      if (!failure)
        for (LA::Vector &solution : solutions)
          low_rank.correct(solution);
      return solutions;
    }

    ShellModel   &model;
    LinearSolver &linear_solver;
    /** Why a system was not solved, if any. */
    std::optional<Failure> failure;
    /** The displacements per unit of each load parameter; empty if they are
     * prescribed. */
    std::vector<LA::Vector> per_parameter;

  private:
    std::vector<LA::Vector>
    solve_with_matrix(const std::vector<LA::Vector> &forces)
    {
      constexpr double exactness = 1e-12;

      const LA::Vector          none = model.mesh->owned_vector();
      std::vector<LA::Vector>   solutions(forces.size(), none);
      std::vector<unsigned int> inexact(forces.size());
      std::iota(inexact.begin(), inexact.end(), 0);
      std::vector<LA::Vector> left = forces;
      // solvers stop at a residual that is small enough for Newton's method
      for (unsigned int pass = 0; pass < 2 && !failure; ++pass)
        {
          std::vector<LA::Vector> corrections(left.size(), none);
          check(linear_solver.solve_all(corrections, left, exactness));
          std::vector<unsigned int> still_inexact;
          std::vector<LA::Vector>   still_left;
          for (unsigned int i = 0; i < inexact.size(); ++i)
            {
              const LA::Vector &force    = forces[inexact[i]];
              LA::Vector       &solution = solutions[inexact[i]];
              solution += corrections[i];
              if (model.equations.tangent().residual(
                    left[i], solution, force) <= exactness * force.l2_norm())
                continue;
              still_inexact.push_back(inexact[i]);
              still_left.push_back(left[i]);
            }
          // only what is not exact enough is solved for once more
          inexact = still_inexact;
          left    = still_left;
        }
      for (LA::Vector &solution : solutions)
        model.mesh->constraints.distribute(solution);
      return solutions;
    }

    void
    check(const LinearSolverResult &result)
    {
      if (!result.success)
        failure = Failure{result.cause, result.message};
    }

    LowRankStiffness low_rank;
  };


  void
  SensitivityAnalysis::start(const Step &step, PerturbedRun &perturbed) const
  {
    // the proposal of the run, from the start of the perturbed run
    Control::Memory        memory = step.memory;
    const Control::Memory &own    = perturbed.progress.control;
    memory.start                  = own.start;
    for (const auto &number : own.numbers)
      if (number.first.rfind("start", 0) == 0)
        memory.numbers[number.first] = number.second;
    perturbed.run->control->restore(memory);
    perturbed.trial =
      perturbed.run->control->propose(perturbed.run->last_converged());
    // the run may have replaced a step beyond the end of the stage
    if (!step.trial.equations)
      perturbed.trial.equations = nullptr;

    State &state       = perturbed.state;
    state.displacement = step.state.displacement;
    // its own, which depend on the entries of the stages
    state.time_step =
      perturbed.run->time_step_to(perturbed.trial.level(step.mu));
    for (unsigned int i = 0; i < state.contacts.size(); ++i)
      {
        // the active set of the run is held, section 11
        state.contacts[i].active   = step.state.contacts[i].active;
        state.contacts[i].statuses = step.state.contacts[i].statuses;
      }
    perturbed.model.equations.move_supports(
      state, perturbed.run->loads_at(perturbed.trial.level(step.mu)));
    perturbed.fixed     = owned_part(state.displacement);
    perturbed.deviation = {model.mesh->owned_vector(),
                           LoadParameters(step.mu.size())};
    perturbed.balanced  = perturbed.deviation;
    move(step, perturbed);
  }


  void
  SensitivityAnalysis::move(const Step &step, PerturbedRun &perturbed) const
  {
    LoadParameters mu = step.mu;
    add(mu, 1, perturbed.deviation.mu);
    perturbed.level = perturbed.trial.level(mu);
    perturbed.loads = perturbed.run->loads_at(perturbed.level);

    State &state = perturbed.state;
    // the very positions for which the forces were evaluated: contact is so
    // stiff that the last digit matters
    // named, since a temporary would be moved together with its partition,
    // which has no ghosts
    const LA::Vector balanced  = perturbed.balanced_displacements(),
                     since     = perturbed.since_balanced();
    state.displacement         = balanced;
    LoadParameters balanced_mu = step.mu;
    add(balanced_mu, 1, perturbed.balanced.mu);
    LoadRates change;
    if (perturbed.trial.equations)
      {
        LoadParameters mu_since = perturbed.deviation.mu;
        add(mu_since, -1, perturbed.balanced.mu);
        change = perturbed.trial.equations->change_of_loads(mu_since);
      }
    // pressures change linearly from there on, section 11: in their difference
    // the round-off of positions cancels
    const auto contact_before = perturbed.model.contact.linearize(
      state,
      perturbed.run->loads_at(perturbed.trial.level(balanced_mu)),
      change);
    LA::Vector moved = perturbed.fixed;
    moved += perturbed.deviation.displacements;
    state.displacement           = moved;
    LA::Vector ghosted_increment = model.mesh->ghosted_vector();
    ghosted_increment            = since;
    perturbed.loads =
      perturbed.model.equations.with_dependent_loads(state, perturbed.loads);
    perturbed.level.pressure = perturbed.loads.pressure;
    perturbed.model.contact.compute_multipliers(
      state, perturbed.loads, contact_before, ghosted_increment);
  }


  LA::Vector
  SensitivityAnalysis::unbalance(const Step       &step,
                                 const LA::Vector &here,
                                 PerturbedRun     &perturbed) const
  {
    // Friction is linearized at these pressures. A small motion of the
    // ground at fixed displacements changes the pressure, which limits it,
    // by a multiple of itself.
    take_multipliers(step.state, perturbed.state);
    LA::Vector forces = perturbed.model.equations.out_of_balance_forces(
      perturbed.state, perturbed.loads);
    forces -= here;
    return forces;
  }


  LoadParameters
  SensitivityAnalysis::missing_loads(
    const Step                    &step,
    const std::vector<LA::Vector> &per_parameter,
    const PerturbedRun            &perturbed) const
  {
    // like the balance of forces: where they were evaluated, and linearly from
    // there
    State at = perturbed.state;
    take_multipliers(step.state, at);
    LA::Vector total = perturbed.balanced_displacements();
    at.displacement  = total;
    total -= owned_part(perturbed.before.displacement);
    // the gradients are those of the run: where contact is stiff, those of the
    // perturbed shell would not fit its tangent
    const LA::Vector total_of_run = change(step.run.state, step.state);
    return perturbed.trial.equations->parameter_changes_about(
      {{model.equations, model.contact, step.state, step.loads},
       total_of_run,
       {}},
      {{perturbed.model.equations,
        perturbed.model.contact,
        at,
        perturbed.loads},
       total,
       {}},
      perturbed.since_balanced(),
      per_parameter);
  }


  void
  SensitivityAnalysis::follow(const Step &step)
  {
    if (!is_read(step) || lost_stages.count(step.run.progress.stage) > 0)
      return;
    TimerOutput::Scope scope(timer, "Sensitivities");

    // the histories at the start of the step are read until it is committed
    for (const auto &perturbed : perturbed_runs)
      {
        perturbed->before       = perturbed->state;
        perturbed->level_before = perturbed->progress.reached;
      }
    Linearization tangent(model, linear_solver, step);
    if (!tangent.failure)
      carry_along(step, tangent);
    if (tangent.failure)
      lose(step, *tangent.failure);
  }


  SensitivityAnalysis::Balance
  SensitivityAnalysis::balance_of_run(const Step          &step,
                                      const Linearization &tangent) const
  {
    Balance      balance;
    const double relative = model.equations.relative_residual();
    if (relative > 0)
      balance.roundoff = 10 * model.equations.residual().l2_norm() / relative *
                         model.equations.relative_roundoff(step.state);
    balance.forces =
      model.equations.out_of_balance_forces(step.state, step.loads);
    if (step.trial.equations)
      {
        const LA::Vector total = change(step.run.state, step.state);
        balance.missing_loads  = step.trial.equations->parameter_changes(
          {{model.equations, model.contact, step.state, step.loads}, total, {}},
          model.mesh->owned_vector(),
          tangent.per_parameter);
      }
    return balance;
  }


  void
  SensitivityAnalysis::correct(const Step                    &step,
                               const LA::Vector              &correction,
                               const std::vector<LA::Vector> &per_parameter,
                               const LoadParameters          &missing_in_run,
                               PerturbedRun                  &perturbed) const
  {
    // the forces were evaluated before this correction
    perturbed.balanced = perturbed.deviation;
    perturbed.deviation.displacements += correction;
    move(step, perturbed);
    if (!step.trial.equations)
      return;

    // the loads change until the controlled quantity is missed by no more than
    // in the run
    LoadParameters further = missing_loads(step, per_parameter, perturbed);
    add(further, -1, missing_in_run);
    add(perturbed.deviation.mu, 1, further);
    for (unsigned int i = 0; i < further.size(); ++i)
      perturbed.deviation.displacements.add(further[i], per_parameter[i]);
    move(step, perturbed);
  }


  bool
  SensitivityAnalysis::is_near(const unsigned int e) const
  {
    // beyond the size of the shell, or not a number, this is no small change
    for (unsigned int side = 0; side < 2; ++side)
      if (!(perturbed_runs[2 * e + side]
              ->deviation.displacements.linfty_norm() < model.mesh->size()))
        return false;
    return true;
  }


  bool
  SensitivityAnalysis::is_linear(const unsigned int e,
                                 const Sides       &forces,
                                 const Sides       &corrections,
                                 const double       roundoff)
  {
    const auto mean_and_difference = [](const Sides &sides) {
      LA::Vector sum = *sides[1], difference = *sides[1];
      sum += *sides[0];
      difference -= *sides[0];
      return std::make_pair(sum.l2_norm() / 2, difference.l2_norm());
    };
    const auto [mean, difference] = mean_and_difference(forces);
    const auto [mean_correction, difference_of_corrections] =
      mean_and_difference(corrections);
    if (is_straight(-difference / 2, mean, difference / 2, roundoff))
      return is_straight(-difference_of_corrections / 2,
                         mean_correction,
                         difference_of_corrections / 2,
                         0);
    warn(parameters.sensitivities.changes[e], "the balance of forces");
    return false;
  }


  void
  SensitivityAnalysis::make_opposite(const Step &step, const unsigned int e)
  {
    // where all is linear, the mean of both sides is only round-off: half of
    // their difference remains, with either sign
    PerturbedRun &below           = *perturbed_runs[2 * e],
                 &above           = *perturbed_runs[2 * e + 1];
    PerturbedRun::Deviation &half = above.deviation;
    half.displacements -= below.deviation.displacements;
    half.displacements *= 0.5;
    add(half.mu, -1, below.deviation.mu);
    for (double &mu : half.mu)
      mu /= 2;
    below.deviation.displacements = half.displacements;
    below.deviation.displacements *= -1;
    below.deviation.mu.assign(half.mu.size(), 0);
    add(below.deviation.mu, -1, half.mu);
    move(step, below);
    move(step, above);
  }


  bool
  SensitivityAnalysis::has_settled(const unsigned int e,
                                   const Sides       &forces,
                                   const double       roundoff) const
  {
    constexpr double exact = 1e-7;

    bool settled = true;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const PerturbedRun &perturbed = *perturbed_runs[2 * e + side];
        settled =
          settled && (forces[side]->l2_norm() <= roundoff ||
                      perturbed.since_balanced().l2_norm() <=
                        exact * perturbed.deviation.displacements.l2_norm());
      }
    return settled;
  }


  void
  SensitivityAnalysis::carry_along(const Step &step, Linearization &tangent)
  {
    const Balance here = balance_of_run(step, tangent);
    if (!are_finite(here.missing_loads))
      {
        tangent.failure = Failure{FailureCause::control,
                                  "the controlled quantity does not depend on "
                                  "the loads",
                                  step.trial.equations->remedies()};
        return;
      }
    // both sides of each entry, as far as no earlier stage has lost it
    std::vector<unsigned int> followed;
    for (unsigned int e = 0; e < parameters.sensitivities.changes.size(); ++e)
      if (follows(e, step.run.progress.stage))
        {
          followed.push_back(e);
          for (unsigned int side = 0; side < 2; ++side)
            start(step, *perturbed_runs[2 * e + side]);
        }

    // The forces are only linear where the perturbed runs have followed: a
    // motion of the ground at fixed displacements changes the pressures by
    // many times themselves, and a small slip changes its direction.
    constexpr unsigned int    max_passes = 15;
    std::vector<unsigned int> unsettled  = followed, lost;
    for (unsigned int pass = 0; pass < max_passes && !unsettled.empty(); ++pass)
      {
        std::vector<LA::Vector> forces;
        for (const unsigned int e : unsettled)
          for (unsigned int side = 0; side < 2; ++side)
            forces.push_back(
              unbalance(step, here.forces, *perturbed_runs[2 * e + side]));
        // all entries at once, with the same factors
        const std::vector<LA::Vector> corrections = tangent.solve(forces);
        if (tangent.failure)
          return;

        std::vector<unsigned int> still_unsettled;
        for (unsigned int i = 0; i < unsettled.size(); ++i)
          {
            const unsigned int e = unsettled[i];
            for (unsigned int side = 0; side < 2; ++side)
              correct(step,
                      corrections[2 * i + side],
                      tangent.per_parameter,
                      here.missing_loads,
                      *perturbed_runs[2 * e + side]);
            const Sides of_forces{{&forces[2 * i], &forces[2 * i + 1]}};
            const Sides of_corrections{
              {&corrections[2 * i], &corrections[2 * i + 1]}};
            if (!is_near(e))
              lost.push_back(e);
            else if (pass == 0 && !model.contact.has_friction(step.loads) &&
                     is_linear(e, of_forces, of_corrections, here.roundoff))
              // without friction, the forces of contact are linear, too
              make_opposite(step, e);
            else if (!has_settled(e, of_forces, here.roundoff))
              still_unsettled.push_back(e);
          }
        unsettled = still_unsettled;
      }
    lost.insert(lost.end(), unsettled.begin(), unsettled.end());
    for (const unsigned int e : lost)
      leave_unsettled(step, e);

    for (const unsigned int e : followed)
      for (unsigned int side = 0;
           side < 2 && follows(e, step.run.progress.stage);
           ++side)
        {
          PerturbedRun &perturbed    = *perturbed_runs[2 * e + side];
          perturbed.progress.reached = perturbed.level;
          perturbed.model.equations.internal_forces().settle_resultants(
            perturbed.state);
          // results and the next steps read the histories that follow from here
          perturbed.model.equations.commit_step(
            perturbed.before, perturbed.loads, step.time, perturbed.state);
        }
  }


  void
  SensitivityAnalysis::lose(const Step &step, const Failure &failure)
  {
    InUse in_use            = step.run.stage.in_use(step.run.progress.stage);
    in_use.iterative_solver = parameters.linear_solver.is_iterative();
    // no state between two steps must remain
    for (const auto &perturbed : perturbed_runs)
      perturbed->state = perturbed->before;
    lost_stages.insert(step.run.progress.stage);
    out << "  Warning: the derivatives in " << step.run.stage.name
        << " and in stages that start from its end are left out: "
        << failure.message << ". Possible remedies: " << advice(failure, in_use)
        << std::endl;
  }


  void
  SensitivityAnalysis::leave_unsettled(const Step &step, const unsigned int e)
  {
    for (unsigned int side = 0; side < 2; ++side)
      {
        PerturbedRun &perturbed = *perturbed_runs[2 * e + side];
        perturbed.state         = perturbed.before;
      }
    unsettled.insert({step.run.progress.stage, e});
    out << "  Warning: the derivatives by the entry '"
        << parameters.sensitivities.changes[e].name << "' in "
        << step.run.stage.name
        << " and in stages that start from its end are not a number: with "
           "small changes of the entry no equilibrium was found; see "
           "'Sensitivities/Relative step'"
        << std::endl;
  }


  bool
  SensitivityAnalysis::reads_left_eigenvectors(const unsigned int stage) const
  {
    return (results.have_frequency() || results.have_buckling()) &&
           parameters.sensitivities.is_wanted(stage, parameters.stages.size());
  }


  void
  SensitivityAnalysis::end_stage(const StageRun &run, StepReport &report)
  {
    const unsigned int position = report.instant.stage;
    if (lost_stages.count(position) > 0)
      return;
    TimerOutput::Scope scope(timer, "Sensitivities");
    // also where no derivatives are wanted, since later stages go on from here
    for (PerturbedRun *perturbed : followers(position))
      perturbed->progress.end_stage(perturbed->run->stage);
    const SensitivityParameters &asked = parameters.sensitivities;
    if (!asked.is_wanted(position, parameters.stages.size()))
      return;

    const auto evaluate = [](const ScalarResults &results,
                             const ShellModel    &model,
                             const StepReport    &report,
                             const State         &state) {
      return results.evaluate(
        model.equations, model.cavity.get(), report, state);
    };
    auto                      table = std::make_shared<SensitivityTable>();
    const std::vector<double> here =
      evaluate(results, model, report, run.state);
    const auto &names = results.get_names();
    for (unsigned int o = 0; o < names.size(); ++o)
      table->outputs.push_back({names[o], here[o]});
    std::set<unsigned int> not_finite;
    for (unsigned int e = 0; e < asked.changes.size(); ++e)
      {
        const Change &change = asked.changes[e];
        table->entries.push_back({change.name, change.value});
        table->derivatives.emplace_back(
          names.size(), std::numeric_limits<double>::quiet_NaN());
        if (!follows(e, position))
          continue;
        std::array<std::vector<double>, 2> values;
        for (unsigned int side = 0; side < 2; ++side)
          {
            // what a perturbed run does not change is that of the run
            PerturbedRun &perturbed = *perturbed_runs[2 * e + side];
            StepReport    changed   = report;
            report_contact(*perturbed.run,
                           perturbed.run->loads_at(perturbed.progress.reached),
                           changed);
            if (results.have_force())
              changed.forces_of_bodies = forces_on_shell(
                perturbed.model.equations,
                perturbed.state,
                forces_in_equilibrium(
                  perturbed.model, perturbed.state, *changed.loads));
            if (results.have_stiffness())
              {
                Progress &progress = perturbed.progress;
                progress.reactions =
                  perturbed.reactions(perturbed.before, perturbed.level_before);
                changed.stiffness = stiffness_of_motions(
                  *perturbed.run,
                  perturbed.reactions(perturbed.state, progress.reached));
              }
            if (report.modes && results.have_frequency())
              changed.modes = change_modes(*report.modes,
                                           run.state,
                                           *report.loads,
                                           perturbed,
                                           *changed.loads);
            if (report.buckling && results.have_buckling())
              changed.buckling =
                change_buckling(*report.buckling, perturbed, *changed.loads);
            values[side] = evaluate(
              perturbed.results, perturbed.model, changed, perturbed.state);
          }
        for (unsigned int o = 0; o < names.size(); ++o)
          {
            if (std::isnan(here[o]))
              continue;
            const double derivative =
              (values[1][o] - values[0][o]) / change.step;
            if (std::isfinite(derivative))
              table->derivatives[e][o] = derivative;
            else
              not_finite.insert(o);
            // at a kink both sides deviate in the same direction
            if (!is_straight(values[0][o],
                             here[o],
                             values[1][o],
                             1e-9 * std::abs(here[o])))
              warn(change, "'" + names[o] + "'");
          }
      }
    for (const unsigned int o : not_finite)
      if (std::isfinite(here[o]))
        out << "  Warning: '" << names[o]
            << "' is not differentiable here; a frequency, for example, is "
               "not at the onset of flutter, where two modes coincide"
            << std::endl;
    report.sensitivities = table;
  }


  std::shared_ptr<const VibrationModes>
  SensitivityAnalysis::change_modes(const VibrationModes &modes,
                                    const State          &state,
                                    const Loads          &loads,
                                    PerturbedRun         &perturbed,
                                    const Loads          &changed_loads)
  {
    const auto squares = [&](ShellModel       &of,
                             State             at,
                             const LA::Vector &displacement,
                             const Loads      &under) {
      at.displacement = displacement;
      of.equations.internal_forces().settle_resultants(at);
      std::vector<std::complex<double>> result =
        omegas_for_shapes(of.equations, of.contact, timer, at, under, modes);
      for (std::complex<double> &omega : result)
        omega *= omega;
      return result;
    };
    // the shapes of a thin shell that turns do not turn with it, which stiffens
    // them by the square of its motion: it is the same on either side, unless
    // the entry changes, too
    const LA::Vector here   = owned_part(state.displacement),
                     motion = change(state, perturbed.state);
    LA::Vector above = here, below = here;
    above += motion;
    below -= motion;
    const auto squares_above = squares(model, state, above, loads),
               squares_below = squares(model, state, below, loads),
               squares_here =
                 squares(perturbed.model, perturbed.state, here, changed_loads);

    auto changed = std::make_shared<VibrationModes>(modes);
    for (unsigned int m = 0; m < squares_here.size(); ++m)
      {
        // the square is smooth, also where it is much smaller than its change
        std::complex<double> &omega = changed->modes[m].omega;
        omega += (squares_here[m] - omega * omega +
                  (squares_above[m] - squares_below[m]) / 2.) /
                 (2. * omega);
      }
    return changed;
  }


  std::shared_ptr<const Buckling>
  SensitivityAnalysis::change_buckling(const Buckling &buckling,
                                       PerturbedRun   &perturbed,
                                       const Loads    &loads)
  {
    BucklingAnalysis analysis(
      perturbed.model.equations, perturbed.model.contact, linear_solver, timer);
    BucklingModes changed;
    changed.modes              = buckling.modes;
    const LoadLevel    &start  = perturbed.progress.control.start;
    const BucklingStart before = buckling_start(
      perturbed.state,
      start,
      {perturbed.before, perturbed.level_before},
      [&](const LoadLevel &level) { return perturbed.run->loads_at(level); });
    const bool                sealed    = perturbed.run->stage.sealed;
    const std::vector<double> positions = analysis.quotients(
      {before.state, before.loads}, {perturbed.state, loads}, changed.modes);
    for (unsigned int m = 0; m < positions.size(); ++m)
      changed.modes[m].position = positions[m];
    return std::make_shared<const Buckling>(buckling_from(
      changed, start, before.level, perturbed.progress.reached, sealed));
  }


  void
  SensitivityAnalysis::warn(const Change &change, const std::string &what)
  {
    if (std::count(warned.begin(), warned.end(), change.name + what) > 0)
      return;
    warned.push_back(change.name + what);
    out << "  Warning: forward and backward differences of " << what
        << " by the entry '" << change.name
        << "' disagree; its derivative is uncertain, see "
           "'Sensitivities/Relative step'"
        << std::endl;
  }
} // namespace Biface
