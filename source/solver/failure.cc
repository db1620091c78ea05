// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <biface/solver/failure.h>

namespace Biface
{
  namespace
  {
    const char smaller_steps[] =
      "smaller steps (more 'Steps' in the stage, or 'Step control/Maximum "
      "cuts')";
    const char turning_points[] =
      "where the shell snaps through or buckles, 'Control = displacement' or "
      "'arc length', which pass turning points of the load";
    const char zone_edge[] =
      "shorter cells at the edge of the contact zone, 'Contact/Multiplier mass "
      "= lumped', or a smaller 'Contact/Regularization'";


    std::string
    meaning(const FailureCause cause)
    {
      switch (cause)
        {
          case FailureCause::too_many_iterations:
            return "The iteration neither settled nor diverged; the lines with "
                   "'residual' in run.log show how far it came.";
          case FailureCause::divergence:
            return "The iteration left the neighborhood of the last state: the "
                   "step is too large, or there is no equilibrium near by.";
          case FailureCause::contact_cycle:
            return "The same nodes touch and leave the foundation in turn, and "
                   "no state was found in which they rest.";
          case FailureCause::singular_tangent:
            return "Some motion of the shell meets no resistance: it is not "
                   "held, a material or a ply is nearly without stiffness, or "
                   "the load has come to its greatest value.";
          case FailureCause::out_of_memory:
            return "The matrix did not fit into memory when it was factorized.";
          case FailureCause::linear_iterations:
            return "The linear system was set up, but Krylov's method did not "
                   "solve it as exactly as the step needs.";
          case FailureCause::control:
            return "The displacement or the force that the stage gives does "
                   "not change with the loads.";
          case FailureCause::too_many_steps:
            return "The path of equilibrium goes on, but away from the loads "
                   "of the stage, or slowly.";
        }
      Assert(false, dealii::ExcInternalError());
      return {};
    }


    std::string
    advice(const FailureCause cause, const bool in_contact)
    {
      const std::string contact =
        (in_contact ? std::string("; ") + zone_edge : std::string());
      switch (cause)
        {
          case FailureCause::too_many_iterations:
            return std::string("more 'Newton/Maximum iterations' where the "
                               "residual still falls; ") +
                   smaller_steps + "; " + turning_points + contact;
          case FailureCause::divergence:
            return std::string(smaller_steps) + "; " + turning_points + contact;
          case FailureCause::contact_cycle:
            return std::string(zone_edge) + "; " + smaller_steps;
          case FailureCause::singular_tangent:
            return std::string(
                     "more in the section 'Supports' (rigid motions "
                     "left free are named at the begin of the run); ") +
                   turning_points + "; a look at the plies and moduli";
          case FailureCause::out_of_memory:
            return "fewer cells, 'Contact/Multiplier mass = lumped' (half of "
                   "the matrix will do), 'Linear solver/Type = iterative', or "
                   "more machines";
          case FailureCause::linear_iterations:
            return "more 'Linear solver/Maximum iterations', or 'Linear "
                   "solver/Type = direct'";
          case FailureCause::control:
            return "another 'Control point' or 'Control component'; for a "
                   "force, a stage of given travel before, in which the shell "
                   "comes to rest on the foundation";
          case FailureCause::too_many_steps:
            return "more 'Step control/Maximum arc steps', fewer 'Steps' in "
                   "the stage, or a greater 'Step control/Maximum growth'";
        }
      Assert(false, dealii::ExcInternalError());
      return {};
    }
  } // namespace


  std::string
  explain(const FailureCause cause, const bool in_contact)
  {
    return meaning(cause) + " What may help: " + advice(cause, in_contact) +
           '.';
  }
} // namespace Biface
