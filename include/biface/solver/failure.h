// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_failure_h
#define biface_solver_failure_h

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
    too_many_steps
  };


  /** A failure of a step. */
  struct Failure
  {
    FailureCause cause = FailureCause::too_many_iterations;
    /** What happened, as part of a sentence. */
    std::string message;
  };


  /** The settings of a stage in which a step fails: no remedy names them again.
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
  };


  /** Possible remedies for a failure, as part of a sentence that names entries
   * of the parameter file. */
  std::string
  advice(const FailureCause cause, const InUse &in_use);


  /** The meaning of a failure and possible remedies: sentences for the user
   * that name entries of the parameter file. */
  std::string
  explain(const FailureCause cause, const InUse &in_use);
} // namespace Biface

#endif
