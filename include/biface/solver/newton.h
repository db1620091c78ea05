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

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/failure_cause.h>
#include <biface/solver/linear/linear_solver.h>
#include <biface/solver/path_control.h>

namespace Biface
{
  /** How a Newton iteration ended. */
  struct NewtonResult
  {
    bool         converged  = false;
    unsigned int iterations = 0;
    /** Where it did not converge: why. */
    std::string  message;
    FailureCause cause = FailureCause::too_many_iterations;
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
   * or the update is small. Where the set goes round in a circle, the nodes
   * that toggle are held in contact until all is at rest, and then released,
   * once in a step.
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
           LinearSolver               &linear_solver,
           dealii::ConditionalOStream &out,
           dealii::TimerOutput        &timer,
           const Stop                 &stop = {});

    /** The loads by one number, such as a fraction of a stage, and which
     * condition chooses it. */
    struct Path
    {
      std::function<Loads(const double)> loads;
      /** Null where the number is given. */
      const PathControl *control = nullptr;
    };

    /**
     * Bring a state into equilibrium.
     *
     * @param state the start, then the result; where the iteration did not
     * converge, of no use.
     * @param path the loads.
     * @param number of the path: the start, then where a condition chooses it,
     * the result.
     * @param iteration see NewtonIteration.
     * @param zone_given whether the first iteration takes the contact zone of
     * the state as it is, though its displacements may tell of another.
     */
    NewtonResult
    solve(State                &state,
          const Path           &path,
          double               &number,
          const NewtonIteration iteration,
          const bool            zone_given = false);

    const Parameters parameters;

  private:
    ShellEquations             &equations;
    LinearSolver               &linear_solver;
    dealii::ConditionalOStream &out;
    dealii::TimerOutput        &timer;
    const Stop                  stop;
  };
} // namespace Biface

#endif
