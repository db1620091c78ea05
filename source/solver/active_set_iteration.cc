// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <vector>

#include <biface/base/gather.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/solver/active_set_iteration.h>

namespace Biface
{
  using namespace dealii;

  bool
  ActiveSetCycle::closes_with(const ActiveSet &active)
  {
    sets.push_front(active);
    if (sets.size() > 2 * longest + 1)
      sets.pop_back();

    // differs[p-1]: whether the latest sets differ from those p before them,
    // over one period and one more set
    std::vector<unsigned int> differs(longest, 1);
    for (unsigned int p = 1; p <= longest && 2 * p < sets.size(); ++p)
      {
        differs[p - 1] = 0;
        for (unsigned int j = 0; j <= p; ++j)
          if (sets[j] != sets[j + p])
            differs[p - 1] = 1;
      }
    Utilities::MPI::max(differs, communicator, differs);

    // a constant set is no cycle
    const auto period =
      1 + (std::find(differs.begin(), differs.end(), 0u) - differs.begin());
    if (period == 1 || period > longest)
      return false;

    toggling.assign(active.size(), 0);
    for (unsigned int j = 1; j < period; ++j)
      for (unsigned int n = 0; n < active.size(); ++n)
        if (sets[j][n] != active[n])
          toggling[n] = 1;
    return true;
  }


  std::string
  name_nodes(const ShellMesh &mesh, const ActiveSet &marked)
  {
    constexpr unsigned int most = 5;

    AssertDimension(marked.size(), mesh.nodes.size());
    using Named = std::pair<types::global_cell_index, std::string>;
    std::vector<Named> mine;
    for (unsigned int n = 0; n < marked.size(); ++n)
      {
        const Node &node = mesh.nodes[n];
        if (marked[n] && node.locally_owned)
          mine.emplace_back(node.number, mesh.place_in_words(node));
      }
    std::vector<Named> all;
    for (const auto &part : gather_on_all(mesh.communicator, mine))
      all.insert(all.end(), part.begin(), part.end());
    // by number, so that the text does not depend on the ranks
    std::sort(all.begin(), all.end());

    std::string text = std::to_string(all.size()) +
                       (all.size() == 1 ? " node at " : " nodes at ");
    for (unsigned int i = 0; i < std::min<std::size_t>(all.size(), most); ++i)
      text += (i > 0 ? ", " : "") + all[i].second;
    return text + (all.size() > most ? ", ..." : "");
  }


  ActiveSetIteration::ActiveSetIteration(const ContactInteraction &contact,
                                         ConditionalOStream       &out)
    : contact(contact), out(out), cycle(contact.mesh.communicator)
  {}


  unsigned int
  ActiveSetIteration::update(State &state, const Loads &loads)
  {
    const unsigned int n_changes =
      contact.update_active_set(state, loads, held);
    // usually the set is constant, or grows from the empty set
    if (!cycle.closes_with(contact.active_points(state)))
      return n_changes;

    const std::string nodes =
      name_nodes(contact.mesh, contact.nodes_around(cycle.toggling_nodes()));
    cycle.restart();
    // glue first: it may be the reason why no active set is a solution
    if (contact.release_glue(state, cycle.toggling_nodes()))
      {
        out << "    active set is cycling; no longer glued: " << nodes
            << std::endl;
        return n_changes + contact.update_active_set(state, loads, held);
      }
    if (was_held)
      {
        message =
          "active set is cycling again after it was broken once: " + nodes;
        return n_changes;
      }
    out << "    active set is cycling; holding in contact: " << nodes
        << std::endl;
    was_held = true;
    held     = cycle.toggling_nodes();
    return n_changes + contact.update_active_set(state, loads, held);
  }


  unsigned int
  ActiveSetIteration::settle(State &state, const Loads &loads)
  {
    if (!held.empty())
      {
        out << "    releasing the nodes held in contact" << std::endl;
        held.clear();
        cycle.restart();
      }
    return contact.settle(state, loads);
  }
} // namespace Biface
