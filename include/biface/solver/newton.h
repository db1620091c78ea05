// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_newton_h
#define biface_solver_newton_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/equations/equation_system.h>
#include <biface/solver/control_equation.h>
#include <biface/solver/failure.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  class EntryDeclarations;


  /** The loads as functions of load parameters. */
  struct ParametrizedLoads
  {
    std::function<Loads(const LoadParameters &)> at;
    /** The equations that determine the parameters; null if they are
     * prescribed. */
    const ControlEquations *equations = nullptr;
  };


  /** The result of a Newton iteration. */
  struct NewtonResult
  {
    bool         converged  = false;
    unsigned int iterations = 0;
    /** The reason of a failure, if the iteration did not converge. */
    Failure failure;
    /** Whether the iteration was stopped on request. */
    bool stopped = false;
    /** The relative residuals before each iteration and after the last. */
    std::vector<double> residuals;
    /** The number of negative pivots of the last tangent that was factorized,
     * with the gas, if it was symmetric and the linear solver counts them: the
     * number of unstable directions of this equilibrium, or of an iterate close
     * to it. */
    std::optional<unsigned int> n_negative_pivots;
    /** Whether the negative pivots are those of the tangent, see
     * LinearSolverResult::pivots_are_exact. */
    bool pivots_are_exact = false;

    std::optional<unsigned int>
    exact_pivots() const
    {
      return pivots_are_exact ? n_negative_pivots : std::nullopt;
    }

    void
    set_exact_pivots(const unsigned int n_negative)
    {
      n_negative_pivots = n_negative;
      pivots_are_exact  = true;
    }

    /** Whether it has failed, so that another attempt may help. */
    bool
    failed() const
    {
      return !converged && !stopped;
    }
  };


  /**
   * Newton's method on the displacements and, in its mixed form, on the
   * resultants of every element @cite GrigolyukKulikovPlotnikova2004, with the
   * primal-dual active set method for contact inside: the active set is updated
   * after every iteration, and the iteration has converged when the set is
   * unchanged and the residual or the update is small. Which nodes slip is
   * decided with the active set. The residual is a continuous function of the
   * displacements across this decision, so that it alone decides on
   * convergence. If the active set is cycling, glued nodes that toggle lose
   * their glue; without them, the nodes that toggle are held in contact until
   * the iteration has converged, and then released, once per step.
   */
  class Newton
  {
  public:
    struct Parameters
    {
      unsigned int max_iterations     = 25;
      double       residual_tolerance = 1e-8;
      double       update_tolerance   = 1e-9;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** A function that says whether to stop; called on all ranks, which must
     * obtain the same answer. */
    using Stop = std::function<bool()>;

    /** The objects are kept by reference.
     * @param stop called before each iteration. */
    Newton(const Parameters           &parameters,
           EquationSystem             &equations,
           const ContactInteraction   &contact,
           LinearSolver               &linear_solver,
           dealii::ConditionalOStream &out,
           dealii::TimerOutput        &timer,
           const Stop                 &stop = {});

    /**
     * Bring a state into equilibrium.
     *
     * @param state the initial guess, then the result; meaningless if the
     * iteration did not converge.
     * @param loads the loads as functions of the load parameters.
     * @param mu the load parameters: the initial guess, then, if equations
     * determine them, the result.
     * @param iteration see NewtonIteration.
     * @param zone_given whether the first iteration keeps the active set of the
     * state, even if its displacements imply a different one.
     */
    NewtonResult
    solve(State                   &state,
          const ParametrizedLoads &loads,
          LoadParameters          &mu,
          const NewtonIteration    iteration,
          const bool               zone_given = false);

    const Parameters parameters;

  private:
    struct Iterate;

    /** An increment of the displacements and, if they are unknown, of the load
     * parameters. */
    struct Increment
    {
      LA::Vector     displacement;
      LoadParameters mu;
    };

    /** Compute the residual and, unless the iteration is likely to have
     * converged, the tangent. */
    void
    assemble(Iterate &iterate);

    /** Choose the active set of the first iteration, if there is no friction,
     * by the linearized equations, among the points in which the set of the
     * initial guess differs from that of the last step; see
     * CondensedContact. */
    void
    choose_active_set(Iterate &iterate);

    /** Compute the tangent that assemble() left out. */
    void
    complete(Iterate &iterate);

    /** Whether the tangent of the last iterate is good enough for what is
     * likely to be the last increment. */
    bool
    keeps_tangent(const Iterate &iterate) const;

    /** Whether the iterate, whose residual is not known yet, is likely to be
     * the last one. */
    bool
    expects_convergence(const Iterate &iterate) const;

    bool
    is_converged(const Iterate &iterate) const;

    /** Whether the equations for the load parameters are satisfied, if there
     * are any. */
    bool
    is_satisfied(const Iterate &iterate) const;

    Failure
    too_many_iterations(const Iterate &iterate) const;

    /**
     * The tolerance of the next linear solve, in the norm of the solver
     * @cite EisenstatWalker1996: the square of the last reduction of the
     * residual, but not below what would not change the last iterate, and at
     * most a number that depends on the contact.
     * @param few_digits whether the active set has settled and this is the only
     * system of the iteration: the direction of a load may be much larger than
     * its effect.
     */
    double
    forcing_term(const Iterate &iterate, const bool few_digits) const;

    /** Solve the linear systems of an iteration.
     * @return the failure, if any. */
    std::optional<Failure>
    compute_increment(Iterate &iterate, Increment &increment);

    /** The failure of an iteration whose equations do not determine the load
     * parameters. Must be called on all ranks. */
    Failure
    undetermined_loads(const Iterate                 &iterate,
                       const Increment               &increment,
                       const std::vector<LA::Vector> &per_parameter) const;

    /** Add an increment and update the active set.
     * @return the failure, if any. */
    std::optional<Failure>
    move(Iterate &iterate, const Increment &increment);

    EquationSystem             &equations;
    const ContactInteraction   &contact;
    LinearSolver               &linear_solver;
    dealii::ConditionalOStream &out;
    dealii::TimerOutput        &timer;
    const Stop                  stop;
  };
} // namespace Biface

#endif
