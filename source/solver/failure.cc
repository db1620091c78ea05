// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <biface/solver/failure.h>

namespace Biface
{
  namespace
  {
    std::string
    zone_edge(const InUse &in_use)
    {
      return "smaller cells at the edge of the contact zone, or a smaller '" +
             in_use.section_of_regularization +
             "/Regularization' or, with friction, '" +
             in_use.section_of_tangential_regularization +
             "/Tangential regularization'";
    }


    std::string
    smaller_steps(const Failure &failure)
    {
      // more cuts only if they ended the step
      return std::string("smaller steps (more 'Steps' in the stage") +
             (failure.iterations_used_up ? ")"
                                         : ", or 'Step control/Maximum cuts')");
    }


    /** The controls that pass turning points and are not in use, after a
     * semicolon. */
    std::string
    turning_points(const InUse &in_use)
    {
      const std::string start = "; if the shell snaps through or buckles, ";
      if (in_use.arc_length_control || in_use.in_time)
        return {};
      if (in_use.displacement_control)
        return start + "'Control = arc length', which also passes turning "
                       "points of the displacement";
      return start + "'Control = displacement' or 'arc length', which pass "
                     "turning points of the load";
    }


    std::string
    meaning(const FailureCause cause)
    {
      // without a default, so that the compiler asks for the sentence of a new
      // cause
      switch (cause)
        {
          case FailureCause::too_many_iterations:
            return "The iteration neither converged nor diverged; the lines "
                   "with 'residual' in run.log show its course.";
          case FailureCause::divergence:
            return "The iteration diverged or became NaN: the step is too "
                   "large, or there is no equilibrium nearby.";
          case FailureCause::other_solution:
            return "The iteration converged, but to a solution that cannot "
                   "follow the last step: the step is too large.";
          case FailureCause::heat:
            return "The losses in rolling and the temperatures that follow "
                   "from them, computed in turn, go on changing.";
          case FailureCause::error_in_time:
            return "The accelerations change faster than the steps that are "
                   "allowed follow them.";
          case FailureCause::contact_cycle:
            return "The same nodes enter and leave contact in turn, and "
                   "holding them in contact did not help.";
          case FailureCause::singular_tangent:
            return "The tangent stiffness is singular: supports are missing, "
                   "a material or a ply has almost no stiffness, or the load "
                   "has reached its maximum.";
          case FailureCause::linear_solver:
            return "A linear system was not solved.";
          case FailureCause::out_of_memory:
            return "The factorized matrix did not fit into memory.";
          case FailureCause::linear_iterations:
            return "The Krylov method did not solve a linear system as "
                   "accurately as the step needs.";
          case FailureCause::nonlocal_iterations:
            return "The stresses that relax around the axle change too much "
                   "in the step.";
          case FailureCause::control:
            return "At the start of the step, the prescribed displacement or "
                   "force does not change with the loads.";
          case FailureCause::too_many_steps:
            return "The equilibrium path leads away from the loads of the "
                   "stage, or approaches them too slowly.";
        }
      Assert(false, dealii::ExcInternalError());
      return {};
    }


    std::string
    remedies_of_cause(const Failure &failure, const InUse &in_use)
    {
      const std::string unstable =
        (failure.had_negative_pivots.value_or(true) ? turning_points(in_use)
                                                    : std::string());
      const std::string contact =
        (in_use.contact && failure.contact_changed ? "; " + zone_edge(in_use)
                                                   : std::string());
      switch (failure.cause)
        {
          case FailureCause::too_many_iterations:
            return (failure.residual_decreased
                      ? std::string(
                          "more 'Newton/Maximum iterations', since the "
                          "residual still decreased; ")
                      : std::string()) +
                   smaller_steps(failure) + unstable + contact;
          case FailureCause::divergence:
            return smaller_steps(failure) + unstable + contact;
          case FailureCause::other_solution:
          case FailureCause::heat:
            return smaller_steps(failure);
          case FailureCause::error_in_time:
            return "a larger 'Time error', 'Numerical damping', or more 'Step "
                   "control/Maximum cuts'";
          case FailureCause::contact_cycle:
            return zone_edge(in_use) + "; " + smaller_steps(failure);
          case FailureCause::singular_tangent:
            return std::string("more entries in 'Supports' (the start of the "
                               "run lists free rigid motions)") +
                   turning_points(in_use) + "; other plies or moduli";
          case FailureCause::linear_solver:
            return "the other 'Linear solver/Type'";
          case FailureCause::out_of_memory:
            return std::string("fewer cells, ") +
                   (in_use.iterative_solver
                      ? ""
                      : "'Linear solver/Type = iterative', ") +
                   "or more machines";
          case FailureCause::linear_iterations:
            return "more 'Linear solver/Maximum iterations', or 'Linear "
                   "solver/Type = direct'";
          case FailureCause::nonlocal_iterations:
            return smaller_steps(failure);
          case FailureCause::control:
            return "loads that change what is controlled";
          case FailureCause::too_many_steps:
            return "more 'Step control/Maximum arc steps', fewer 'Steps' in "
                   "the stage, or a larger 'Step control/Maximum growth'";
        }
      Assert(false, dealii::ExcInternalError());
      return {};
    }
  } // namespace


  std::string
  advice(const Failure &failure, const InUse &in_use)
  {
    return (failure.remedies.empty() ? remedies_of_cause(failure, in_use)
                                     : failure.remedies) +
           (failure.further_remedies.empty() ? "" : "; ") +
           failure.further_remedies;
  }


  std::string
  explain(const Failure &failure, const InUse &in_use)
  {
    return meaning(failure.cause) +
           " Possible remedies: " + advice(failure, in_use) + '.';
  }
} // namespace Biface
