// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_newton_h
#define biface_solver_newton_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <biface/model/contact_interaction.h>
#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/control_equation.h>
#include <biface/solver/failure.h>
#include <biface/solver/linear/linear_solver.h>

namespace Biface
{
  /** The loads as functions of one load parameter @f$\mu@f$. */
  struct ParametrizedLoads
  {
    std::function<Loads(const double)> at;
    /** What determines @f$\mu@f$; null where it is given. */
    const ControlEquation *equation = nullptr;
  };


  /** How a Newton iteration ended. */
  struct NewtonResult
  {
    bool         converged  = false;
    unsigned int iterations = 0;
    /** Where it did not converge: why. */
    Failure failure;
    /** Whether it was asked to stop. */
    bool stopped = false;
    /** Relative residuals before each iteration, and after the last. */
    std::vector<double> residuals;
    /** Of the last tangent, where the linear solver counts them: how many ways
     * there are to leave this equilibrium. */
    std::optional<unsigned int> n_negative_pivots;
  };


  /**
   * Newton's method on the displacements and, in its mixed form, on the
   * resultants of every element @cite GrigolyukKulikovPlotnikova2004, with the
   * primal-dual active set of the contact inside: the set is decided anew after
   * every iteration, and the iteration ends when it is at rest and the residual
   * or the update is small. Where the set cycles, the nodes that toggle are
   * held in contact until all is at rest, and then released, once in a step.
   */
  class Newton
  {
  public:
    struct Parameters
    {
      NewtonIteration iteration          = NewtonIteration::mixed;
      unsigned int    max_iterations     = 25;
      double          residual_tolerance = 1e-8;
      double          update_tolerance   = 1e-9;

      void
      add_parameters(dealii::ParameterHandler &prm);

      /** Throws InputError where a value is not usable. */
      void
      check() const;
    };

    /** Whether to stop; asked on all ranks, which must get the same answer. */
    using Stop = std::function<bool()>;

    /** The objects are kept by reference.
     * @param stop asked before each iteration. */
    Newton(const Parameters           &parameters,
           ShellEquations             &equations,
           const ContactInteraction   &contact,
           LinearSolver               &linear_solver,
           dealii::ConditionalOStream &out,
           dealii::TimerOutput        &timer,
           const Stop                 &stop = {});

    /**
     * Bring a state into equilibrium.
     *
     * @param state the start, then the result; where the iteration did not
     * converge, of no use.
     * @param loads as functions of the load parameter.
     * @param mu the load parameter: the start, then, where an equation
     * determines it, the result.
     * @param iteration see NewtonIteration.
     * @param zone_given whether the first iteration takes the contact zone of
     * the state as it is, though its displacements may tell of another.
     */
    NewtonResult
    solve(State                   &state,
          const ParametrizedLoads &loads,
          double                  &mu,
          const NewtonIteration    iteration,
          const bool               zone_given = false);

    const Parameters parameters;

  private:
    struct Iterate;

    /** An increment of the displacements and of the load parameter. */
    struct Increment
    {
      LA::Vector displacement;
      double     mu = 0;
    };

    void
    assemble(Iterate &iterate);

    bool
    is_converged(const Iterate &iterate) const;

    /** Whether the equation for the load parameter is satisfied, if there is
     * one. */
    bool
    is_satisfied(const Iterate &iterate) const;

    Failure
    too_many_iterations(const Iterate &iterate) const;

    /** Solve the linear systems of an iteration.
     * @return why not, where that failed. */
    std::optional<Failure>
    compute_increment(Iterate &iterate, Increment &increment);

    /** Add an increment, and decide the active set anew.
     * @return why not to go on from there, if so. */
    std::optional<Failure>
    move(Iterate &iterate, const Increment &increment);

    ShellEquations             &equations;
    const ContactInteraction   &contact;
    LinearSolver               &linear_solver;
    dealii::ConditionalOStream &out;
    dealii::TimerOutput        &timer;
    const Stop                  stop;
  };
} // namespace Biface

#endif
