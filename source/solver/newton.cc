// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/quantities/inverted_layers.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/state.h>
#include <biface/solver/active_set_iteration.h>
#include <biface/solver/condensed_contact.h>
#include <biface/solver/low_rank_stiffness.h>
#include <biface/solver/newton.h>
#include <biface/solver/nonlocal_correction.h>

namespace Biface
{
  using namespace dealii;

  void
  Newton::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      "Number of iterations after which a step has failed.",
                      Patterns::Integer(1));
    prm.add_parameter("Residual tolerance",
                      residual_tolerance,
                      "A step has converged when the active set is unchanged "
                      "and the residual, relative to the forces that cancel "
                      "in it, is at most this. At most 0.01.",
                      Patterns::Double(),
                      Unit::none());
    prm.add_parameter("Update tolerance",
                      update_tolerance,
                      "A step has also converged when the active set is "
                      "unchanged, the maximum nodal update relative to the "
                      "thickness is at most this, and the relative residual "
                      "is at most 1e-3. At most 0.01.",
                      Patterns::Double(),
                      Unit::none());
  }


  void
  Newton::Parameters::check() const
  {
    // part of the forces and of the thickness; beyond it, nothing is in
    // equilibrium
    constexpr double maximum = 1e-2;

    check_positive("Newton/Residual tolerance", residual_tolerance);
    check_not_negative("Newton/Update tolerance", update_tolerance);
    check_at_most("Newton/Residual tolerance", residual_tolerance, maximum);
    check_at_most("Newton/Update tolerance", update_tolerance, maximum);
  }


  Newton::Newton(const Parameters         &parameters,
                 EquationSystem           &equations,
                 const ContactInteraction &contact,
                 LinearSolver             &linear_solver,
                 ConditionalOStream       &out,
                 TimerOutput              &timer,
                 const Stop               &stop)
    : parameters(parameters)
    , equations(equations)
    , contact(contact)
    , linear_solver(linear_solver)
    , out(out)
    , timer(timer)
    , stop(stop)
  {}


  /** The current iterate. */
  struct Newton::Iterate
  {
    Iterate(State                    &state,
            const ParametrizedLoads  &path,
            LoadParameters           &mu,
            const NewtonIteration     iteration,
            const bool                zone_given,
            const EquationSystem     &equations,
            const ContactInteraction &contact,
            ConditionalOStream       &out)
      : equations(equations)
      , contact(contact)
      , state(state)
      , parametrized(path)
      , mu(mu)
      , iteration(iteration)
      , zone_given(zone_given)
      , loads(equations.with_dependent_loads(state, path.at(mu)))
      , zone(contact, out)
      , last_active(contact.active_points(state))
      , n_changes(zone_given ? 0 : zone.update(state, loads))
      , total(contact.mesh.owned_vector())
    {
      if (zone_given)
        contact.make_slipping_points_stick(state);
    }

    const EquationSystem     &equations;
    const ContactInteraction &contact;
    State                    &state;
    const ParametrizedLoads  &parametrized;
    LoadParameters           &mu;
    const NewtonIteration     iteration;
    const bool                zone_given;
    Loads                     loads;
    ActiveSetIteration        zone;
    /** The active set of the last step. */
    const ActiveSet last_active;
    /** The points that come and go, without friction. */
    std::optional<CondensedContact> condensed;
    /** Changes of the active set in the last update. */
    unsigned int n_changes;
    /** Change of the displacements since the start, and the largest entry of
     * the last increment. */
    LA::Vector total;
    double     last_update = std::numeric_limits<double>::infinity();
    /** What the last increment may have left, as the linear solver and the last
     * two increments tell. */
    double last_error = 0;
    /** Whether the tangent is that of this iterate. */
    bool has_tangent = false;
    /** Whether residual and tangent are assembled already. */
    bool is_assembled = false;

    NewtonResult result;

    /** The number of the last iteration in which the active set changed, or
     * the number of nodes that slip. */
    std::optional<unsigned int> last_change;
    unsigned int                n_slipping = 0;
    /** See Failure. */
    std::optional<bool> had_negative_pivots;

    /** A failure with what the iteration shows about it. */
    Failure
    with_evidence(const Failure &why) const
    {
      // of iterations, which are called the last ones
      constexpr unsigned int last = 3;
      // of the residual in these
      constexpr double decrease = 0.5;

      Failure                    failure   = why;
      const std::vector<double> &residuals = result.residuals;
      failure.contact_changed =
        last_change && *last_change + last > result.iterations;
      failure.residual_decreased =
        residuals.size() > last &&
        residuals.back() <= decrease * residuals[residuals.size() - 1 - last];
      failure.had_negative_pivots = had_negative_pivots;
      return failure;
    }

    /** Whether the active set has settled. What a coarser mesh gave and which
     * nodes slip take an iteration to be checked, and an equation one to be
     * satisfied. */
    bool
    is_at_rest() const
    {
      return result.iterations == 0
               ? parametrized.equations == nullptr && !zone_given &&
                   !contact.has_friction(loads)
               : n_changes == 0;
    }

    ControlEquations::Iteration
    here() const
    {
      return {
        {equations, contact, state, loads}, total, result.n_negative_pivots};
    }
  };


  namespace
  {
    /** The number of the node with the largest entry of a vector, the lowest
     * of several; none if an entry is not a number. Must be called on all
     * ranks. */
    std::optional<types::global_cell_index>
    largest_node(const ShellMesh &mesh, const LA::Vector &vector)
    {
      constexpr auto none =
        std::numeric_limits<types::global_cell_index>::max();
      // round-off does not decide between nodes that mirror each other
      const double bound  = (1 - 1e-6) * vector.linfty_norm();
      auto         lowest = none;
      for (const Node &node : mesh.nodes)
        if (node.locally_owned)
          for (const auto dof : node.dofs)
            if (std::abs(vector(dof)) >= bound)
              lowest = std::min(lowest, node.number);
      lowest = Utilities::MPI::min(lowest, mesh.communicator);
      return lowest < none ? std::optional(lowest) : std::nullopt;
    }
  } // namespace


  NewtonResult
  Newton::solve(State                   &state,
                const ParametrizedLoads &loads,
                LoadParameters          &mu,
                const NewtonIteration    iteration,
                const bool               zone_given)
  {
    Iterate iterate(
      state, loads, mu, iteration, zone_given, equations, contact, out);
    // what follows from the displacements of the whole shell, such as internal
    // variables in a wheel that rolls, must be there before forces are computed
    const std::string unprepared = equations.prepare(iterate.loads, state);
    NewtonResult     &result     = iterate.result;
    Increment         increment;
    increment.displacement = equations.mesh.owned_vector();

    const auto fail = [&](const Failure &why) {
      result.failure = iterate.with_evidence(why);
      if (result.iterations > 0)
        result.failure.moved_most =
          largest_node(equations.mesh, increment.displacement);
      return result;
    };
    if (!unprepared.empty())
      return fail({FailureCause::divergence, unprepared});
    choose_active_set(iterate);
    while (true)
      {
        if (stop && stop())
          {
            result.stopped = true;
            return fail({FailureCause::too_many_iterations, "stopped"});
          }

        assemble(iterate);
        if (!std::isfinite(result.residuals.back()))
          return fail(
            {FailureCause::divergence, "the residual is not a number"});

        if (is_converged(iterate))
          {
            // multipliers of the iterates are predictions; those of the result
            // are of its clearances, which may change the set
            iterate.n_changes = iterate.zone.settle(state, iterate.loads);
            if (iterate.n_changes > 0)
              {
                result.residuals.pop_back();
                continue;
              }
            TimerOutput::Scope scope(timer, "Update of the state");
            // Green's strains do not distinguish a director from its opposite
            if (const auto inverted =
                  find_inverted_layer(equations.mesh, state))
              return fail({FailureCause::other_solution,
                           "the iteration converged to a shape in which "
                           "layer " +
                             std::to_string(inverted->layer + 1) +
                             " is turned inside out in cell " +
                             std::to_string(inverted->cell)});
            equations.settle(state);
            result.converged = true;
            return result;
          }
        if (result.iterations == parameters.max_iterations)
          return fail(too_many_iterations(iterate));

        // the residual has not converged after all, so that an increment needs
        // the tangent that was saved
        complete(iterate);
        if (const auto failure = compute_increment(iterate, increment))
          return fail(*failure);
        if (const auto failure = move(iterate, increment))
          return fail(*failure);
      }
  }


  namespace
  {
    Symmetry
    symmetry(const EquationSystem &equations, const Loads &loads)
    {
      if (equations.tangent_is_symmetric(loads))
        return Symmetry::full;
      return equations.is_symmetric_but_for_loads(loads) ? Symmetry::nearly
                                                         : Symmetry::none;
    }
  } // namespace


  void
  Newton::choose_active_set(Iterate &iterate)
  {
    State       &state = iterate.state;
    const Loads &loads = iterate.loads;
    if (loads.bodies.empty() || contact.has_friction(loads) ||
        !linear_solver.can_keep_factors())
      return;
    CondensedContact &condensed =
      iterate.condensed.emplace(equations, contact, linear_solver);
    // the set of a coarser mesh is kept in the first iteration
    if (iterate.n_changes == 0 || iterate.zone_given)
      return;

    const ActiveSet extrapolated = contact.active_points(state);
    const auto      candidates =
      condensed.differences(extrapolated, iterate.last_active);
    if (!condensed.has_room_for(candidates))
      return;
    // section 7 of doc/theory.md: the factors are those without the points that
    // come and go
    ActiveSet others = extrapolated;
    for (unsigned int i = 0; i < others.size(); ++i)
      others[i] = extrapolated[i] && iterate.last_active[i];
    contact.set_active_points(state, others);
    {
      TimerOutput::Scope scope(timer, "Assembly");
      equations.assemble(state, loads);
    }
    std::optional<ActiveSet> chosen;
    if (linear_solver.factorize(equations.tangent(), symmetry(equations, loads))
          .success)
      {
        condensed.restart(state);
        chosen =
          condensed.choose(state, loads, candidates, equations.residual());
      }
    if (!chosen)
      {
        contact.set_active_points(state, extrapolated);
        iterate.condensed.reset();
        return;
      }
    TimerOutput::Scope scope(timer, "Assembly");
    contact.set_active_points(state, *chosen);
    equations.add_contact(state, loads);
    for (unsigned int i = 0; i < others.size(); ++i)
      others[i] = others[i] || (*chosen)[i];
    contact.set_active_points(state, others);
    iterate.has_tangent  = true;
    iterate.is_assembled = true;
  }


  Failure
  Newton::too_many_iterations(const Iterate &iterate) const
  {
    const bool balanced =
      iterate.result.residuals.back() <= parameters.residual_tolerance;
    const std::string n = std::to_string(iterate.result.iterations);
    return {FailureCause::too_many_iterations,
            balanced && !is_satisfied(iterate)
              ? "the forces are in balance, but the controlled value was not "
                "reached in " +
                  n + " iterations"
              : "no convergence in " + n + " iterations"};
  }


  void
  Newton::assemble(Iterate &iterate)
  {
    TimerOutput::Scope scope(timer, "Assembly");
    if (!iterate.is_assembled)
      {
        // the last residual of a step needs no tangent, most of the time of an
        // assembly
        iterate.has_tangent = !expects_convergence(iterate);
        if (iterate.has_tangent)
          equations.assemble(iterate.state, iterate.loads);
        else
          equations.assemble_residual(iterate.state, iterate.loads);
      }
    iterate.is_assembled = false;

    NewtonResult &result = iterate.result;
    result.residuals.push_back(equations.relative_residual());
    char update[16] = "";
    if (result.iterations > 0)
      std::snprintf(update, sizeof(update), "%9.3e", iterate.last_update);
    char line[128];
    std::snprintf(line,
                  sizeof(line),
                  "    iteration %2u  residual %9.3e  update %9s  active %4u"
                  "  changes %4u",
                  result.iterations,
                  result.residuals.back(),
                  update,
                  contact.count_active(iterate.state),
                  iterate.n_changes);
    out << line;
    if (contact.has_friction(iterate.loads))
      {
        const unsigned int n_slipping =
          contact.count_slipping(iterate.state, iterate.loads);
        if (result.iterations > 0 && n_slipping != iterate.n_slipping)
          iterate.last_change = result.iterations;
        iterate.n_slipping = n_slipping;
        std::snprintf(line, sizeof(line), "  slipping %4u", n_slipping);
        out << line;
      }
    out << std::endl;
  }


  void
  Newton::complete(Iterate &iterate)
  {
    if (iterate.has_tangent || keeps_tangent(iterate))
      return;
    TimerOutput::Scope scope(timer, "Assembly");
    equations.assemble(iterate.state, iterate.loads);
    iterate.has_tangent = true;
  }


  bool
  Newton::keeps_tangent(const Iterate &iterate) const
  {
    // The last tangent differs from this one by what the last increment changed
    // in it, which also is what is left of the last residual.
    constexpr double           safety    = 0.1;
    const std::vector<double> &residuals = iterate.result.residuals;
    const unsigned int         n         = residuals.size();
    return linear_solver.can_keep_factors() && n >= 2 &&
           residuals[n - 1] * residuals[n - 1] <=
             safety * parameters.residual_tolerance * residuals[n - 2];
  }


  bool
  Newton::expects_convergence(const Iterate &iterate) const
  {
    if (iterate.result.iterations == 0 || !iterate.is_at_rest())
      return false;
    // each residual is about the square of the last one
    const double last = iterate.result.residuals.back();
    return last * last <= parameters.residual_tolerance;
  }


  bool
  Newton::is_converged(const Iterate &iterate) const
  {
    // larger residuals are neither round-off nor stagnation
    constexpr double maximum_residual = 1e-3;
    // relative error of the displacements at which round-off ends the iteration
    constexpr double maximum_error = 1e-4;

    const double thickness = equations.mesh.thickness();
    const double residual  = iterate.result.residuals.back();
    const bool   standstill =
      iterate.last_update <= parameters.update_tolerance * thickness;
    // a shell that moves as a rigid body has no other forces than round-off
    const auto is_roundoff = [&]() {
      return standstill && !equations.has_given_forces() &&
             equations.relative_roundoff(iterate.state) >= 1;
    };
    return iterate.is_at_rest() &&
           equations.support_violation() <=
             std::max(parameters.update_tolerance * thickness,
                      1e-12 * equations.mesh.size()) &&
           (residual <= parameters.residual_tolerance ||
            (residual <= maximum_residual &&
             (standstill ||
              (iterate.last_error <=
                 maximum_error * iterate.state.displacement.linfty_norm() &&
               residual <= equations.relative_roundoff(iterate.state)))) ||
            is_roundoff()) &&
           is_satisfied(iterate);
  }


  bool
  Newton::is_satisfied(const Iterate &iterate) const
  {
    // a contact force has fewer digits than the clearances from which it is
    // computed
    constexpr double minimum_tolerance = 1e-6;

    const ControlEquations *control = iterate.parametrized.equations;
    return control == nullptr ||
           control->violation(iterate.here()) <=
             std::max(parameters.residual_tolerance, minimum_tolerance);
  }


  double
  Newton::forcing_term(const Iterate &iterate, const bool few_digits) const
  {
    constexpr double gamma = 0.9, no_trace = 1e-3, minimum = 1e-10;
    constexpr double of_last = 1e-2;

    const std::vector<double> &residuals = iterate.result.residuals;
    const double               now       = residuals.back(),
                 tolerance               = parameters.residual_tolerance;
    if (few_digits)
      {
        // The first residual was that of contact forces where the shell was
        // expected to touch, and tells nothing. The next residual is about the
        // square of this one.
        constexpr double maximum = 1e-4;
        return now * now > tolerance
                 ? maximum
                 : std::min(maximum, of_last * tolerance / now);
      }
    // Contact is stiff, so that small errors of large increments change the
    // active set. Steps that start from a coarser mesh have small increments.
    const double maximum = (iterate.zone_given ? 1e-3 : 1e-6);
    if (residuals.size() < 2 || now == 0)
      return maximum;
    const double ratio = now / residuals[residuals.size() - 2];
    return std::min(
      maximum,
      std::max({gamma * ratio * ratio, no_trace * tolerance / now, minimum}));
  }


  std::optional<Failure>
  Newton::compute_increment(Iterate &iterate, Increment &increment)
  {
    std::optional<CondensedContact> &condensed = iterate.condensed;
    const bool                       settled =
      iterate.result.iterations > 0 && iterate.n_changes == 0;
    LowRankStiffness low_rank(equations, iterate.state, iterate.loads);
    const double     exactness =
      forcing_term(iterate,
                   settled && condensed && !iterate.parametrized.equations &&
                     !iterate.loads.rolling && low_rank.is_zero());

    // a solution may take new factors
    LinearSolverResult linear, factorized;
    const auto         count_pivots = [&]() {
      if (linear.n_negative_pivots)
        factorized = linear;
      NewtonResult &result     = iterate.result;
      result.pivots_are_exact  = factorized.pivots_are_exact;
      result.n_negative_pivots = {};
      if (const auto &n = factorized.n_negative_pivots)
        result.n_negative_pivots =
          low_rank.n_negative(linear_solver.has_kept_factors() && condensed
                                ? condensed->n_negative(*n)
                                : *n);
      if (const auto &n = result.n_negative_pivots)
        iterate.had_negative_pivots =
          *n > 0 || iterate.had_negative_pivots.value_or(false);
    };

    std::optional<LinearSolver::Correction> correction;
    if (condensed)
      correction = condensed->correction(iterate.state, iterate.loads);
    const Symmetry known = symmetry(equations, iterate.loads);
    if (correction || settled)
      linear = linear_solver.keep_factors(
        equations.tangent(),
        known,
        correction.value_or(LinearSolver::Correction()));
    else
      linear = linear_solver.factorize(equations.tangent(), known);
    count_pivots();
    if (linear.success)
      linear = linear_solver.solve(
        increment.displacement, equations.residual(), exactness);
    count_pivots();
    if (!linear.success)
      return Failure{linear.cause, linear.message};
    equations.distribute(increment.displacement);
    const NonlocalCorrection nonlocal(
      equations,
      iterate.state,
      [&](LA::Vector &solution, const LA::Vector &forces) {
        linear = linear_solver.solve(solution, forces, exactness);
        return linear;
      },
      exactness);
    if (const auto failure =
          nonlocal.correct(increment.displacement, equations.residual()))
      return Failure{failure->cause, failure->message};
    increment.mu.clear();
    iterate.last_error = linear.error * increment.displacement.linfty_norm();

    // the displacements per given forces; supported ones do not change
    const auto solve = [&](LA::Vector &solution, const LA::Vector &forces) {
      linear = linear_solver.solve(solution, forces, exactness);
      count_pivots();
      equations.mesh.constraints.distribute(solution);
      if (linear.success)
        if (const auto failure = nonlocal.correct(solution, forces))
          linear = *failure;
      return linear.success;
    };

    if (!low_rank.prepare(solve))
      return linear.success ? Failure{FailureCause::singular_tangent,
                                      "the pressure of the gas is not "
                                      "determined"}
                            : Failure{linear.cause, linear.message};
    count_pivots();
    LA::Vector supports = equations.mesh.owned_vector();
    equations.distribute(supports);
    low_rank.correct(increment.displacement, &supports);

    if (const ControlEquations *control = iterate.parametrized.equations)
      {
        // a solver that does not need them for the solution may count them
        if (auto &n = iterate.result.n_negative_pivots;
            !n && known != Symmetry::none &&
            control->reads_pivots(iterate.here()))
          if ((n = linear_solver.count_negative_pivots(equations.tangent(),
                                                       true)))
            n = low_rank.n_negative(*n);
        const ControlEquations::Iteration here = iterate.here();
        std::vector<LA::Vector>           per_parameter(control->rates.size(),
                                              equations.mesh.owned_vector());
        for (unsigned int i = 0; i < per_parameter.size(); ++i)
          {
            const auto direction = equations.parameter_direction(
              iterate.state, iterate.loads, control->rates[i]);
            if (!solve(per_parameter[i], direction.forces))
              return Failure{linear.cause, linear.message};
            low_rank.complete(per_parameter[i], direction);
          }
        increment.mu = control->parameter_changes(
          here, increment.displacement, per_parameter);
        for (unsigned int i = 0; i < per_parameter.size(); ++i)
          {
            if (!std::isfinite(increment.mu[i]))
              return undetermined_loads(iterate, increment, per_parameter);
            increment.displacement.add(increment.mu[i], per_parameter[i]);
          }
      }
    if (condensed && !linear_solver.has_kept_factors())
      condensed->restart(iterate.state);
    return {};
  }


  Failure
  Newton::undetermined_loads(const Iterate                 &iterate,
                             const Increment               &increment,
                             const std::vector<LA::Vector> &per_parameter) const
  {
    bool finite = std::isfinite(increment.displacement.l2_norm());
    for (const LA::Vector &direction : per_parameter)
      finite = std::isfinite(direction.l2_norm()) && finite;
    if (!finite)
      return {FailureCause::divergence,
              "the solution of a linear system is not a number"};
    if (iterate.result.iterations == 0)
      return {FailureCause::control,
              "the controlled quantity does not depend on the loads",
              iterate.parametrized.equations->remedies()};

    // what an iterate has lost says nothing about the equations
    const std::string  so = ", so that the controlled quantity did not depend "
                            "on the loads";
    const unsigned int n_active = contact.count_active(iterate.state);
    if (n_active == 0 && !iterate.loads.bodies.empty())
      return {FailureCause::divergence, "an iteration lost all contact" + so};
    if (n_active > 0 &&
        contact.count_slipping(iterate.state, iterate.loads) == n_active)
      return {FailureCause::divergence,
              "in an iteration all nodes in contact slipped" + so};
    return {FailureCause::divergence,
            "the iteration went where the controlled quantity does not depend "
            "on the loads"};
  }


  std::optional<Failure>
  Newton::move(Iterate &iterate, const Increment &increment)
  {
    TimerOutput::Scope scope(timer, "Update of the state");
    if (!increment.mu.empty())
      add(iterate.mu, 1, increment.mu);
    iterate.total += increment.displacement;
    // before the displacements change: predicted multipliers belong to this
    // linear system
    const ControlEquations *control  = iterate.parametrized.equations;
    const auto              contacts = contact.linearize(
      iterate.state,
      iterate.loads,
      control ? control->change_of_loads(increment.mu) : LoadRates());
    equations.update(iterate.state, increment.displacement, iterate.iteration);
    iterate.loads = equations.with_dependent_loads(
      iterate.state, iterate.parametrized.at(iterate.mu));
    const std::string unprepared =
      equations.prepare(iterate.loads, iterate.state);
    contact.predict_multipliers(iterate.state, iterate.loads, contacts);
    iterate.n_changes = iterate.zone.update(iterate.state, iterate.loads);
    if (iterate.n_changes > 0)
      iterate.last_change = iterate.result.iterations + 1;
    const double update = increment.displacement.linfty_norm();
    // updates that shrink slowly leave more than the linear solver knows of
    if (iterate.result.iterations > 0)
      {
        const double ratio = update / iterate.last_update;
        iterate.last_error =
          std::max(iterate.last_error,
                   ratio < 0.5 ? update * ratio / (1 - ratio) : update);
      }
    iterate.last_update = update;
    ++iterate.result.iterations;

    if (!(iterate.last_update <= 1e3 * equations.mesh.size()))
      return Failure{FailureCause::divergence,
                     "the iteration diverged: an update exceeded 1000 times "
                     "the size of the shell"};
    if (!unprepared.empty())
      return Failure{FailureCause::divergence, unprepared};
    if (!iterate.zone.failure().empty())
      return Failure{FailureCause::contact_cycle, iterate.zone.failure()};
    return {};
  }
} // namespace Biface
