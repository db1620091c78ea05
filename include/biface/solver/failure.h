// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_failure_h
#define biface_solver_failure_h

#include <deal.II/base/types.h>

#include <optional>
#include <string>

namespace Biface
{
  /** Why a step failed. */
  enum class FailureCause
  {
    /** The iteration neither converged nor diverged. */
    too_many_iterations,
    /** The iteration diverged or became NaN. */
    divergence,
    /** The active set is cycling. */
    contact_cycle,
    /** The tangent is singular. */
    singular_tangent,
    out_of_memory,
    /** The Krylov method did not reach its tolerance. */
    linear_iterations,
    /** That for the nonlocal part of a linear system did not. */
    nonlocal_iterations,
    /** The controlled quantity does not depend on the loads. */
    control,
    /** The maximum number of steps is reached. */
    too_many_steps,
    /** The iteration converged to a solution other than the one that is
     * sought. */
    other_solution,
    /** Rolling and the conduction of heat, computed in turn, do not settle. */
    heat,
    /** A step in time is too long for the accelerations in it. */
    error_in_time,
    /** A linear solver failed for a reason of its own. */
    linear_solver
  };


  /** The failure of an attempt at a step, and what the attempt showed. */
  struct Failure
  {
    FailureCause cause = FailureCause::too_many_iterations;
    /** What happened, as part of a sentence. */
    std::string message;
    /** What may help, as part of a sentence that names entries of the parameter
     * file, if the cause alone does not tell; otherwise empty. */
    std::string remedies{};
    /** What may help besides, as part of a sentence; empty for nothing. */
    std::string further_remedies{};
    /** Whether the step was not halved again because its attempts have used up
     * the iterations allowed. */
    bool iterations_used_up = false;
    /** Whether nodes came into contact, left it, or began or ceased to slip in
     * the last iterations. */
    bool contact_changed = false;
    /** Whether the residual decreased in the last iterations. */
    bool residual_decreased = false;
    /** Whether a tangent had negative pivots; not set if none were counted. */
    std::optional<bool> had_negative_pivots{};
    /** The number of the node that moved most in the last iteration, see
     * Node::number; none if there was no iteration. */
    std::optional<dealii::types::global_cell_index> moved_most{};

    /** Whether the wall itself may be the reason: a tangent was that of an
     * unstable shell or, if this is not known, the iteration failed in settled
     * contact. */
    bool
    may_lie_in_the_wall() const
    {
      return (cause == FailureCause::too_many_iterations ||
              cause == FailureCause::divergence) &&
             had_negative_pivots.value_or(!contact_changed);
    }
  };


  /** The settings of a stage in which a step fails, on which remedies depend.
   */
  struct InUse
  {
    /** Whether the stage has contact. */
    bool contact = false;
    /** Whether the 'Control' of the stage is 'displacement' or 'arc length'. */
    bool displacement_control = false;
    bool arc_length_control   = false;
    /** Whether the 'Type' of the linear solver is 'iterative'. */
    bool iterative_solver = false;
    /** The sections whose 'Regularization' and 'Tangential regularization' the
     * stage has. */
    std::string section_of_regularization            = "Contact";
    std::string section_of_tangential_regularization = "Contact";
    /** Whether the stage has inertia, so that no path turns back. */
    bool in_time = false;
  };


  /** Possible remedies for a failure, as part of a sentence that names entries
   * of the parameter file: those for which the attempt gives a reason, and that
   * are not in use. */
  std::string
  advice(const Failure &failure, const InUse &in_use);


  /** The meaning of a failure and possible remedies: sentences for the user
   * that name entries of the parameter file. */
  std::string
  explain(const Failure &failure, const InUse &in_use);
} // namespace Biface

#endif
