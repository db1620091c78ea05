// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_active_set_iteration_h
#define biface_solver_active_set_iteration_h

#include <deal.II/base/conditional_ostream.h>

#include <string>

#include <biface/model/shell_equations.h>
#include <biface/model/state.h>
#include <biface/solver/active_set_cycle.h>

namespace Biface
{
  /**
   * The active set of the contact in the iterations of one step. Where it goes
   * round in a circle, the nodes that toggle are held in contact, until the
   * iteration has converged with them and they are released. A second circle is
   * not broken.
   */
  class ActiveSetIteration
  {
  public:
    /** The objects are kept by reference. */
    ActiveSetIteration(const ShellEquations       &equations,
                       dealii::ConditionalOStream &out);

    /** Decide anew which nodes are in contact.
     * @return the number of changes, on all ranks. */
    unsigned int
    update(State &state, const Loads &loads);

    /** Let go of nodes that are held.
     * @return the number of changes, on all ranks. */
    unsigned int
    release(State &state, const Loads &loads);

    /** Of the circle that was not broken: a sentence; empty without one. */
    const std::string &
    failure() const
    {
      return message;
    }

  private:
    const ShellEquations        &equations;
    dealii::ConditionalOStream  &out;
    ActiveSetCycle               cycle;
    ContactConditions::ActiveSet held;
    bool                         was_held = false;
    std::string                  message;
  };
} // namespace Biface

#endif
