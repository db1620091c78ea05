// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

#include <biface/base/errors.h>
#include <biface/model/quantities/footprint.h>
#include <biface/program/sensitivity_analysis.h>
#include <biface/solver/buckling_analysis.h>
#include <biface/solver/low_rank_stiffness.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/sensitivity_table.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_reporting.h>

namespace Biface
{
  using namespace dealii;

  /** A run with a changed entry. */
  struct SensitivityAnalysis::Neighbor
  {
    Neighbor(std::shared_ptr<const Parameters> given,
             std::shared_ptr<const ShellMesh>  mesh)
      : parameters(std::move(given))
      , model(*parameters, std::move(mesh))
      , state(*model.mesh)
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
                                       progress,
                                       state);
    }

    const std::shared_ptr<const Parameters> parameters;
    ShellModel                              model;
    State                                   state;
    Progress                                progress;
    StageEnds                               ends;
    /** The current stage. */
    std::unique_ptr<StageRun> run;

    /** The step that is followed: its loads, and the state before it. */
    Control::Trial trial;
    LoadLevel      level;
    Loads          loads;
    State          before;
    LoadLevel      level_before;
  };


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
        same =
          mesh.nodes[n].dofs == changed.nodes[n].dofs &&
          mesh.nodes[n].number == changed.nodes[n].number &&
          mesh.nodes[n].outer_face_free == changed.nodes[n].outer_face_free;
      if (Utilities::MPI::min(static_cast<unsigned int>(same),
                              mesh.communicator) == 0)
        throw InputError("Sensitivities/Entries",
                         name,
                         "a small change of it must not change the nodes of "
                         "the mesh");
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


    /** The forces on the nodes, with those of the foundation that balance the
     * others where it is in contact: stiff contact makes the round-off of
     * positions large, but equilibrium is known. */
    NodalForces
    forces_in_equilibrium(const ShellEquations &equations,
                          const State          &state,
                          const Loads          &loads)
    {
      const ShellMesh &mesh       = equations.mesh;
      NodalForces      forces     = equations.nodal_forces(state, loads);
      LA::Vector      &foundation = forces[ForceTerm::Source::foundation];
      LA::Vector       sum        = foundation;
      sum += forces[ForceTerm::Source::shell];
      sum += forces[ForceTerm::Source::loads];
      mesh.condense(sum);
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].locally_owned && state.active[n])
          for (const auto dof : mesh.nodes[n].dofs)
            if (!mesh.constraints.is_constrained(dof))
              foundation(dof) -= sum(dof);
      foundation.compress(VectorOperation::add);
      return forces;
    }


  } // namespace


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
    , results("Sensitivities/Outputs",
              parameters.sensitivities.outputs,
              *model.mesh,
              parameters.output.criteria,
              parameters.output.forces.moment_center,
              ScalarResults::Known::at_ends(model.cavity.get(),
                                            wanted_stages(parameters)),
              ScalarResults::Columns::differentiable)
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
          neighbors.push_back(std::make_unique<Neighbor>(changed, mesh));
        }
  }


  SensitivityAnalysis::~SensitivityAnalysis() = default;


  NeighborPoints
  SensitivityAnalysis::get_restore_points() const
  {
    NeighborPoints points{{}, lost_stages};
    for (const auto &neighbor : neighbors)
      {
        points.runs.push_back({neighbor->restore_point(), neighbor->ends});
        // zeros are not written; they follow from the displacements
        for (Modes::Vector &resultants :
             points.runs.back().last.state.resultants)
          resultants = 0;
      }
    return points;
  }


  void
  SensitivityAnalysis::restore(const NeighborPoints &points)
  {
    AssertDimension(points.runs.size(), neighbors.size());
    lost_stages = points.lost_stages;
    for (unsigned int i = 0; i < neighbors.size(); ++i)
      {
        Neighbor &neighbor = *neighbors[i];
        neighbor.restore(points.runs[i].last);
        neighbor.model.equations.internal_forces().settle_resultants(
          neighbor.state);
        neighbor.ends = points.runs[i].ends;
        if (neighbor.progress.stage_begun)
          neighbor.enter_stage();
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
        if (is_branched_from(parameters.stages, last) &&
            lost_stages.count(last) == 0)
          for (const auto &neighbor : neighbors)
            {
              RestorePoint end     = neighbor->restore_point();
              end.progress.control = Control::Memory();
              neighbor->ends.insert_or_assign(last, std::move(end));
            }
        if (lost_stages.count(*before) > 0)
          {
            lost_stages.insert(stage);
            return;
          }
        if (*before != last)
          for (const auto &neighbor : neighbors)
            neighbor->restore(neighbor->ends.at(*before));
      }
    for (const auto &neighbor : neighbors)
      {
        neighbor->progress.stage       = stage;
        neighbor->progress.stage_begun = false;
        neighbor->enter_stage();
        neighbor->run->start();
      }
  }


  bool
  SensitivityAnalysis::is_read(const Step &step) const
  {
    // the next step reads the history of friction, and the displacements if
    // their change is controlled
    const bool buckles =
      results.have_buckling() && step.run.stage.n_buckling > 0;
    return step.run.is_complete() || has_friction(step.loads) ||
           step.trial.equations || buckles;
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
          std::vector<LA::Vector> directions;
          for (const LoadRates &rates : step.trial.equations->rates)
            directions.push_back(
              equations.load_direction(step.state, step.loads, rates));
          per_parameter = solve(directions);
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


  LA::Vector
  SensitivityAnalysis::Derivative::balanced_at(const unsigned int side,
                                               const double       half) const
  {
    LA::Vector result = fixed[side];
    result.add(half, balanced);
    return result;
  }


  LA::Vector
  SensitivityAnalysis::Derivative::since_balanced(const double half) const
  {
    LA::Vector result = displacements;
    result -= balanced;
    result *= half;
    return result;
  }


  double
  SensitivityAnalysis::half_step(const unsigned int e,
                                 const unsigned int side) const
  {
    return (side == 0 ? -0.5 : 0.5) * parameters.sensitivities.changes[e].step;
  }


  LA::Vector
  SensitivityAnalysis::propose(const Step &step, Neighbor &neighbor) const
  {
    // the proposal of the run, from the start of the neighbor
    Control::Memory        memory = step.memory;
    const Control::Memory &own    = neighbor.progress.control;
    memory.start                  = own.start;
    for (const auto &number : own.numbers)
      if (number.first.rfind("start", 0) == 0)
        memory.numbers[number.first] = number.second;
    neighbor.run->control->restore(memory);
    neighbor.trial =
      neighbor.run->control->propose(neighbor.run->last_converged());
    // the run may have replaced a step beyond the end of the stage
    if (!step.trial.equations)
      neighbor.trial.equations = nullptr;

    State &state       = neighbor.state;
    state.displacement = step.state.displacement;
    state.active       = step.state.active;
    state.grips        = step.state.grips;
    neighbor.model.equations.move_supports(
      state, neighbor.run->loads_at(neighbor.trial.level(step.mu)));
    return owned_part(state.displacement);
  }


  SensitivityAnalysis::Derivative
  SensitivityAnalysis::start(const Step &step, const unsigned int e) const
  {
    Derivative derivative{{{propose(step, *neighbors[2 * e]),
                            propose(step, *neighbors[2 * e + 1])}},
                          model.mesh->owned_vector(),
                          model.mesh->owned_vector(),
                          LoadParameters(step.mu.size()),
                          LoadParameters(step.mu.size())};
    move(step, e, derivative);
    return derivative;
  }


  void
  SensitivityAnalysis::move(const Step        &step,
                            const unsigned int e,
                            const Derivative  &derivative) const
  {
    for (unsigned int side = 0; side < 2; ++side)
      {
        Neighbor      &neighbor = *neighbors[2 * e + side];
        const double   half     = half_step(e, side);
        LoadParameters mu       = step.mu;
        add(mu, half, derivative.mu);
        neighbor.level = neighbor.trial.level(mu);
        neighbor.loads = neighbor.run->loads_at(neighbor.level);

        State &state = neighbor.state;
        // the very positions for which the forces were evaluated: contact is so
        // stiff that the last digit matters
        const LA::Vector balanced  = derivative.balanced_at(side, half);
        state.displacement         = balanced;
        LoadParameters balanced_mu = step.mu;
        add(balanced_mu, half, derivative.balanced_mu);
        const auto contact_before = neighbor.model.contact.linearize(
          state, neighbor.run->loads_at(neighbor.trial.level(balanced_mu)));
        double travel = 0;
        if (neighbor.trial.equations)
          for (unsigned int i = 0; i < mu.size(); ++i)
            travel += half * (derivative.mu[i] - derivative.balanced_mu[i]) *
                      neighbor.trial.equations->rates[i].travel;
        const LA::Vector increment = derivative.since_balanced(half);
        LA::Vector       moved     = derivative.fixed[side];
        moved.add(half, derivative.displacements);
        state.displacement           = moved;
        LA::Vector ghosted_increment = model.mesh->ghosted_vector();
        ghosted_increment            = increment;
        neighbor.loads = neighbor.model.equations.with_dependent_loads(
          neighbor.state, neighbor.loads);
        neighbor.level.pressure = neighbor.loads.pressure;
        neighbor.model.contact.compute_multipliers(
          state, neighbor.loads, contact_before, ghosted_increment, travel);
      }
  }


  LA::Vector
  SensitivityAnalysis::force_rate(const Step        &step,
                                  const unsigned int e,
                                  const LA::Vector  &here,
                                  const double       roundoff)
  {
    const Change             &change = parameters.sensitivities.changes[e];
    std::array<LA::Vector, 2> forces;
    for (unsigned int side = 0; side < 2; ++side)
      {
        Neighbor &neighbor = *neighbors[2 * e + side];
        // Friction is linearized at these pressures. A small motion of the
        // foundation at fixed displacements changes the pressure, which limits
        // it, by a multiple of itself.
        neighbor.state.multipliers = step.state.multipliers;
        forces[side] = neighbor.model.equations.out_of_balance(neighbor.state,
                                                               neighbor.loads);
      }
    LA::Vector difference = forces[1];
    difference -= forces[0];
    if (!has_friction(step.loads))
      {
        LA::Vector curvature = forces[1];
        curvature += forces[0];
        curvature.add(-2, here);
        const double size = difference.l2_norm();
        check_step(change,
                   -size / 2,
                   curvature.l2_norm() / 2,
                   size / 2,
                   roundoff,
                   "the balance of forces");
      }
    difference /= change.step;
    return difference;
  }


  bool
  SensitivityAnalysis::correct_loads(
    const Step                    &step,
    const unsigned int             e,
    const std::vector<LA::Vector> &per_parameter,
    Derivative                    &derivative) const
  {
    LoadParameters further(step.mu.size());
    for (unsigned int side = 0; side < 2; ++side)
      {
        const Neighbor &neighbor = *neighbors[2 * e + side];
        const double    half     = half_step(e, side);

        // like the balance of forces: where they were evaluated, and linearly
        // from there
        State at         = neighbor.state;
        at.multipliers   = step.state.multipliers;
        LA::Vector total = derivative.balanced_at(side, half);
        at.displacement  = total;
        total -= owned_part(neighbor.before.displacement);

        const LoadParameters mu = neighbor.trial.equations->parameter_changes(
          {neighbor.model.equations,
           neighbor.model.contact,
           at,
           neighbor.loads,
           total,
           {}},
          derivative.since_balanced(half),
          per_parameter);
        add(further, 1 / (2 * half), mu);
      }
    if (!std::all_of(further.begin(), further.end(), [](const double mu) {
          return std::isfinite(mu);
        }))
      return false;
    add(derivative.mu, 1, further);
    for (unsigned int i = 0; i < further.size(); ++i)
      derivative.displacements.add(further[i], per_parameter[i]);
    move(step, e, derivative);
    return true;
  }


  void
  SensitivityAnalysis::follow(const Step &step)
  {
    if (!is_read(step) || lost_stages.count(step.run.progress.stage) > 0)
      return;
    TimerOutput::Scope scope(timer, "Sensitivities");

    for (const auto &neighbor : neighbors)
      {
        neighbor->before       = neighbor->state;
        neighbor->level_before = neighbor->progress.reached;
      }
    Linearization tangent(model, linear_solver, step);
    if (!tangent.failure)
      carry_along(step, tangent);
    if (tangent.failure)
      lose(step, *tangent.failure);
  }


  void
  SensitivityAnalysis::carry_along(const Step &step, Linearization &tangent)
  {
    const LA::Vector here     = model.equations.residual();
    const double     relative = model.equations.relative_residual();
    const double     roundoff =
      (relative > 0 ? 10 * here.l2_norm() / relative *
                        model.equations.relative_roundoff(step.state)
                    : 0.);

    const unsigned int        n = parameters.sensitivities.changes.size();
    std::vector<Derivative>   derivatives;
    std::vector<unsigned int> unsettled(n);
    std::iota(unsettled.begin(), unsettled.end(), 0);
    for (unsigned int e = 0; e < n; ++e)
      derivatives.push_back(start(step, e));

    // with friction, the forces are only linear where the neighbors have
    // followed: the direction of a small slip changes by much
    constexpr unsigned int max_passes = 6;
    constexpr double       exact      = 1e-7;
    for (unsigned int pass = 0; pass < max_passes && !unsettled.empty(); ++pass)
      {
        std::vector<LA::Vector> rates;
        for (const unsigned int e : unsettled)
          {
            rates.push_back(force_rate(step, e, here, roundoff));
            derivatives[e].balanced    = derivatives[e].displacements;
            derivatives[e].balanced_mu = derivatives[e].mu;
          }
        const std::vector<LA::Vector> corrections = tangent.solve(rates);
        if (tangent.failure)
          return;

        std::vector<unsigned int> still_unsettled;
        for (unsigned int i = 0; i < unsettled.size(); ++i)
          {
            const unsigned int e          = unsettled[i];
            Derivative        &derivative = derivatives[e];
            derivative.displacements += corrections[i];
            move(step, e, derivative);
            if (step.trial.equations &&
                !correct_loads(step, e, tangent.per_parameter, derivative))
              {
                tangent.failure = Failure{FailureCause::control,
                                          "the controlled quantity does not "
                                          "depend on the loads"};
                return;
              }
            // without friction, the forces of contact are linear
            if (has_friction(step.loads) &&
                corrections[i].l2_norm() >
                  exact * derivative.displacements.l2_norm())
              still_unsettled.push_back(e);
          }
        unsettled = still_unsettled;
      }
    for (const unsigned int e : unsettled)
      warn(parameters.sensitivities.changes[e], "the slip");

    for (const auto &item : neighbors)
      {
        Neighbor &neighbor        = *item;
        neighbor.progress.reached = neighbor.level;
        neighbor.model.equations.internal_forces().settle_resultants(
          neighbor.state);
        neighbor.model.equations.commit_step(
          neighbor.before, neighbor.loads, step.time, neighbor.state);
      }
  }


  void
  SensitivityAnalysis::lose(const Step &step, const Failure &failure)
  {
    for (const auto &neighbor : neighbors)
      neighbor->state = neighbor->before;
    lost_stages.insert(step.run.progress.stage);
    out << "  Warning: the derivatives in " << step.run.stage.name
        << " and in stages that start from its end are left out: "
        << failure.message << ". Possible remedies: "
        << advice(failure.cause, step.run.stage.contact) << std::endl;
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
    for (const auto &neighbor : neighbors)
      neighbor->progress.end_stage(neighbor->run->stage);
    const SensitivityParameters &asked = parameters.sensitivities;
    if (!asked.is_wanted(position, parameters.stages.size()))
      return;

    const auto evaluate = [&](const ShellModel &model,
                              const StepReport &report,
                              const State      &state) {
      return results.evaluate(
        model.equations, model.cavity.get(), report, state);
    };
    auto                      table = std::make_shared<SensitivityTable>();
    const std::vector<double> here  = evaluate(model, report, run.state);
    const auto               &names = results.get_names();
    for (unsigned int o = 0; o < names.size(); ++o)
      table->outputs.push_back({names[o], here[o]});
    for (unsigned int e = 0; e < asked.changes.size(); ++e)
      {
        const Change                      &change = asked.changes[e];
        std::array<std::vector<double>, 2> values;
        for (unsigned int side = 0; side < 2; ++side)
          {
            Neighbor  &neighbor = *neighbors[2 * e + side];
            StepReport changed  = report;
            report_contact(*neighbor.run,
                           neighbor.run->loads_at(neighbor.progress.reached),
                           changed);
            if (results.have_force())
              changed.forces =
                std::make_shared<const NodalForces>(forces_in_equilibrium(
                  neighbor.model.equations, neighbor.state, changed.loads));
            if (report.modes && results.have_frequency())
              changed.modes =
                change_modes(*report.modes, neighbor, changed.loads);
            if (report.buckling && results.have_buckling())
              changed.buckling =
                change_buckling(*report.buckling, neighbor, changed.loads);
            values[side] = evaluate(neighbor.model, changed, neighbor.state);
          }
        table->entries.push_back({change.name, change.value});
        table->derivatives.emplace_back();
        for (unsigned int o = 0; o < names.size(); ++o)
          {
            const double difference = values[1][o] - values[0][o];
            table->derivatives[e].push_back(difference / change.step);
            check_step(change,
                       values[0][o],
                       here[o],
                       values[1][o],
                       1e-9 * std::abs(here[o]),
                       "'" + names[o] + "'");
          }
      }
    for (unsigned int o = 0; o < names.size(); ++o)
      if (std::isfinite(here[o]) &&
          std::any_of(
            table->derivatives.begin(),
            table->derivatives.end(),
            [&](const auto &of_entry) { return !std::isfinite(of_entry[o]); }))
        out << "  Warning: '" << names[o]
            << "' is not differentiable here; a frequency, for example, is "
               "not at the onset of flutter, where two modes coincide"
            << std::endl;
    report.sensitivities = table;
  }


  std::shared_ptr<const VibrationModes>
  SensitivityAnalysis::change_modes(const VibrationModes &modes,
                                    Neighbor             &neighbor,
                                    const Loads          &loads)
  {
    auto       changed = std::make_shared<VibrationModes>(modes);
    const auto omegas  = omegas_for_shapes(neighbor.model.equations,
                                          neighbor.model.contact,
                                          timer,
                                          neighbor.state,
                                          loads,
                                          modes);
    for (unsigned int m = 0; m < omegas.size(); ++m)
      changed->modes[m].omega = omegas[m];
    return changed;
  }


  std::shared_ptr<const Buckling>
  SensitivityAnalysis::change_buckling(const Buckling &buckling,
                                       Neighbor       &neighbor,
                                       const Loads    &loads)
  {
    BucklingAnalysis analysis(
      neighbor.model.equations, neighbor.model.contact, linear_solver, timer);
    BucklingModes changed;
    changed.modes              = buckling.modes;
    const LoadLevel    &start  = neighbor.progress.control.start;
    const BucklingStart before = buckling_start(
      neighbor.state,
      start,
      {neighbor.before, neighbor.level_before},
      [&](const LoadLevel &level) { return neighbor.run->loads_at(level); });
    const bool                sealed    = neighbor.run->stage.sealed;
    const std::vector<double> positions = analysis.quotients(
      {before.state, before.loads}, {neighbor.state, loads}, changed.modes);
    for (unsigned int m = 0; m < positions.size(); ++m)
      changed.modes[m].position = positions[m];
    return std::make_shared<const Buckling>(buckling_from(
      changed, start, before.level, neighbor.progress.reached, sealed));
  }


  void
  SensitivityAnalysis::check_step(const Change      &change,
                                  const double       below,
                                  const double       here,
                                  const double       above,
                                  const double       roundoff,
                                  const std::string &what)
  {
    // the part of a difference that does not belong to a straight line
    constexpr double smooth = 0.05;

    if (std::abs((above + below) / 2 - here) >
        smooth * std::abs(above - below) + roundoff)
      warn(change, what);
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
