// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_failure_h
#define biface_solver_failure_h

#include <string>

namespace Biface
{
  /** Why a step failed. */
  enum class FailureCause
  {
    /** The iteration neither settled nor diverged. */
    too_many_iterations,
    /** It diverged or became NaN. */
    divergence,
    /** The active set of the contact is cycling. */
    contact_cycle,
    /** The tangent has no inverse. */
    singular_tangent,
    out_of_memory,
    /** Krylov's method did not come to its tolerance. */
    linear_iterations,
    /** What is controlled does not depend on the loads. */
    control,
    /** There may be no more steps. */
    too_many_steps
  };


  struct Failure
  {
    FailureCause cause = FailureCause::too_many_iterations;
    /** What happened: part of a sentence. */
    std::string message;
  };


  /** What a failure means, and what can be done about it: sentences for the
   * user, which name entries of the parameter file.
   * @param in_contact whether the foundation was there. */
  std::string
  explain(const FailureCause cause, const bool in_contact);
} // namespace Biface

#endif
