// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_failure_cause_h
#define biface_solver_failure_cause_h

#include <string>

namespace Biface
{
  /** Why a step came to nothing. */
  enum class FailureCause
  {
    /** The iteration neither settled nor diverged. */
    too_many_iterations,
    /** It left all bounds, or met a number that is none. */
    divergence,
    /** The active set of the contact went round in a circle. */
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


  /** What a failure means, and what can be done about it: sentences for the
   * user, which name entries of the parameter file.
   * @param in_contact whether the foundation was there. */
  std::string
  explain(const FailureCause cause, const bool in_contact);
} // namespace Biface

#endif
