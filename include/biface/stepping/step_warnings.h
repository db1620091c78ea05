// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_step_warnings_h
#define biface_stepping_step_warnings_h

#include <deal.II/base/conditional_ostream.h>

#include <optional>
#include <set>
#include <string>

#include <biface/stepping/stage_analysis.h>

namespace Biface
{
  /** Warns once of states that the user has probably not meant. */
  class StepWarnings : public StageAnalysis
  {
  public:
    /** @param out kept by reference. */
    explicit StepWarnings(dealii::ConditionalOStream &out) : out(out)
    {}

    void
    start_stage(const StageRun                    &run,
                const std::optional<unsigned int> &before) override;

    void
    end_step(const StageRun &run, StepReport &report) override;

  private:
    /** Warn of supported nodes that the ground has passed through. */
    void
    warn_of_pierced_nodes(const StageRun &run, const Loads &loads);

    /** Warn of bodies that are far in the shell between nodes, where there is
     * no contact: their edges are too sharp for the cells. */
    void
    warn_of_large_cells(const StageRun &run, const Loads &loads);

    /** Warn of steep sides that hold nodes in a step that was halved: the shell
     * may have several equilibria there. */
    void
    warn_of_steep_sides(const StageRun &run, const StepReport &report);

    /** Warn of a convex ground on whose far side nodes are. */
    void
    warn_of_pull(const StageRun &run, const StepReport &report);

    /** Warn of stiffnesses of the ground that are not certain. */
    void
    warn_of_stiffness(const StageRun &run, const StepReport &report);

    dealii::ConditionalOStream &out;
    std::set<std::string>       warned_of_pierced_nodes, warned_of_large_cells,
      warned_of_pull, warned_of_steep_sides, warned_of_stiffness;
    bool warned_of_rigid_motions = false;
  };
} // namespace Biface

#endif
