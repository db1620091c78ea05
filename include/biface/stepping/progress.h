// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_progress_h
#define biface_stepping_progress_h

#include <deal.II/base/point.h>

#include <map>
#include <optional>
#include <vector>

#include <biface/base/serialize_optional.h>
#include <biface/model/quantities/work.h>
#include <biface/stepping/controls/control_memory.h>
#include <biface/stepping/moving_reactions.h>
#include <biface/stepping/secant_predictor.h>

namespace Biface
{
  struct Stage;


  /**
   * The progress of a run through the stages: all data that LoadStepping keeps
   * between steps. See RestorePoint.
   */
  struct Progress
  {
    /** Number of converged steps in all stages. */
    unsigned int n_steps = 0;
    /** Position of the current stage, and whether it has started. */
    unsigned int stage       = 0;
    bool         stage_begun = false;
    /** The loads of the last converged step. */
    LoadLevel reached;
    /** The travel at which the ground touches the shell at the start of the
     * first stage with contact, or of the first one after a prestress, see
     * ContactPair::travel_at_first_contact(). */
    std::optional<double> travel_at_first_contact;
    /** The point of the shell that the ground touches first, at the same
     * time as the travel at first contact, see
     * ContactPair::first_contact_point(). */
    dealii::Point<3> first_contact_point;
    /** The load factors in the shape from which displacements count: 0, or
     * those at the start of the last stage from a prestress. Prescribed
     * displacements are proportional to what exceeds them. */
    std::vector<double> factors_of_shape = {0};

    /** The work in all steps, or in those since the last start from a
     * prestress. */
    Work work;

    /** The reactions of supports and bodies at the end of the last step of the
     * stage; not set before its first one. */
    std::optional<MovingReactions> reactions;
    /** The reactions at the start of the stage, without bodies that come there
     * and touch the shell; not a number at supports of a shell under prestress.
     */
    MovingReactions first_reactions;

    /** The rolling radius at the end of the last stage that ended in free
     * rolling, see Biface::free_rolling_radius(). */
    std::optional<double> free_rolling_radius;

    /** The number of negative pivots of the tangent of the last converged
     * step, if it was counted; none for the unloaded shell. */
    std::optional<unsigned int> n_negative_pivots = 0;

    /** The critical shape of the last step, if it ended at a bifurcation and
     * the next one goes on along the other branch (locally owned entries);
     * otherwise empty. */
    LA::Vector branch;

    /** The change of the unknowns in the last step, see
     * Control::Equilibrium. */
    LA::Vector last_change;

    /** The stages that have failed, by position, and why: the run has gone on
     * without them, see Stage::may_fail. */
    std::map<unsigned int, std::string> failed_stages;

    /** The data of the control of the current stage, if it has started. */
    ControlMemory control;

    SecantPredictor predictor;

    /** Whether the stage at @p position has failed and the run has gone on
     * without it. */
    bool
    has_failed(const unsigned int position) const
    {
      return failed_stages.count(position) > 0;
    }

    /** The loads at the start of the current stage. */
    const LoadLevel &
    start_of_stage() const
    {
      return stage_begun ? control.start : reached;
    }

    /** Whether the stages up to @p last_stage are complete. */
    bool
    at_end_of(const unsigned int last_stage) const
    {
      return stage > last_stage || has_failed(last_stage) ||
             (stage_begun && stage == last_stage && control.done >= 1);
    }

    /** A stage as given, completed by what follows from the stages before, see
     * with_angular_velocity(). */
    Stage
    complete(const Stage &given) const;

    /** Record what later stages need to know of the end of the current one. */
    void
    end_stage(const Stage &ended);

    /** Continue with other factors: the position of each among the present
     * ones, see StageLoads::positions_in(). */
    void
    rearrange_factors(const std::vector<unsigned int> &positions);

    /** Change the description of the current stage, if it has started, see
     * Control::change_stage(). */
    void
    change_stage(const Stage &before, const Stage &now);

    /** Archive the numbers; vectors are distributed and stored separately. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_steps &stage &stage_begun &reached;
      serialize_optional(archive, travel_at_first_contact);
      archive &first_contact_point &factors_of_shape &work;
      serialize_optional(archive, reactions);
      archive &first_reactions;
      serialize_optional(archive, free_rolling_radius);
      serialize_optional(archive, n_negative_pivots);
      archive &failed_stages &control &predictor;
    }
  };
} // namespace Biface

#endif
