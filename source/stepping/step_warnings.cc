// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>

#include <biface/solver/active_set_iteration.h>
#include <biface/stepping/step_warnings.h>

namespace Biface
{
  using namespace dealii;

  void
  StepWarnings::end_step(const StageRun &run, StepReport &report)
  {
    warn_of_pierced_nodes(run, report.loads);
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
