// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/solver/active_set_iteration.h>

namespace Biface
{
  using namespace dealii;

  ActiveSetIteration::ActiveSetIteration(const ShellEquations &equations,
                                         ConditionalOStream   &out)
    : equations(equations), out(out), cycle(equations.mesh.communicator)
  {}


  unsigned int
  ActiveSetIteration::update(State &state, const Loads &loads)
  {
    const unsigned int n_changes =
      equations.update_active_set(state, loads, held);
    // a set at rest, or one that grows from nothing, is the rule
    if (!cycle.closes_with(state.active))
      return n_changes;

    const std::string nodes =
      name_nodes(equations.mesh, cycle.toggling_nodes());
    cycle.restart();
    if (was_held)
      {
        message = "the contact zone goes round in a circle, also after it was "
                  "broken once; in turn in contact and apart: " +
                  nodes;
        return n_changes;
      }
    out << "    the contact zone goes round in a circle; held in contact: "
        << nodes << std::endl;
    was_held = true;
    held     = cycle.toggling_nodes();
    return n_changes + equations.update_active_set(state, loads, held);
  }


  unsigned int
  ActiveSetIteration::release(State &state, const Loads &loads)
  {
    if (held.empty())
      return 0;
    out << "    nodes that were held in contact are released" << std::endl;
    held.clear();
    cycle.restart();
    return equations.update_active_set(state, loads);
  }
} // namespace Biface
