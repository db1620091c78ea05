// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdio>

#include <biface/solver/active_set_iteration.h>
#include <biface/stepping/step_warnings.h>

namespace Biface
{
  using namespace dealii;

  void
  StepWarnings::end_step(const StageRun &run, StepReport &report)
  {
    warn_of_pierced_nodes(run, report.loads);
    warn_of_large_cells(run, report.loads);
  }


  void
  StepWarnings::warn_of_large_cells(const StageRun &run, const Loads &loads)
  {
    // of wall and tread
    constexpr double remarkable = 0.05;

    for (const auto &pair : run.contact.pairs)
      {
        // on the foundation the footprint shows whether cells are small
        if (pair.get() == &run.contact.ground() ||
            warned_of_large_cells.count(pair->name) > 0 || !pair->body(loads))
          continue;
        const auto deepest = pair->depth_between_nodes(run.state, loads);
        if (deepest.relative <= remarkable)
          continue;
        char depth[48];
        std::snprintf(depth,
                      sizeof(depth),
                      "%.3g, %.2g %% of its thickness,",
                      deepest.depth,
                      100 * deepest.relative);
        out << "  Warning: between nodes, which alone make contact, the body '"
            << pair->name << "' is in the shell by " << depth
            << " more than at the nodes around; make the cells "
            << "smaller, or its edges rounder, or let 'Points in cells' make "
            << "contact" << std::endl;
        warned_of_large_cells.insert(pair->name);
      }
  }


  void
  StepWarnings::warn_of_pierced_nodes(const StageRun &run, const Loads &loads)
  {
    for (const auto &pair : run.contact.pairs)
      {
        if (warned_of_pierced_nodes.count(pair->name) > 0 || !pair->body(loads))
          continue;
        const ActiveSet pierced = pair->pierced_nodes(run.state, loads);
        const bool      any     = std::any_of(
          pierced.begin(), pierced.end(), [](const char node) { return node; });
        if (!Utilities::MPI::logical_or(any, run.contact.mesh.communicator))
          continue;
        out << "  Warning: "
            << (pair.get() == &run.contact.ground()
                  ? "the foundation"
                  : "the body '" + pair->name + "'")
            << " penetrates supported nodes, which cannot come into contact: "
            << name_nodes(run.contact.mesh, pierced) << std::endl;
        warned_of_pierced_nodes.insert(pair->name);
      }
  }
} // namespace Biface
