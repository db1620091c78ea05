// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/quantities/footprint.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/placed_body.h>
#include <biface/stepping/step_reporting.h>
#include <biface/stepping/stiffness_of_motions.h>

namespace Biface
{
  using namespace dealii;

  void
  report_contact(const StageRun &run, const Loads &loads, StepReport &report)
  {
    const LoadLevel &level = run.progress.reached;
    report.loads           = std::make_shared<const Loads>(loads);
    report.level           = level;
    // motions of earlier stages would look like those of ground that is there
    if (!run.stage.contact)
      for_each_motion([](auto &motion, const auto &zero) { motion = zero; },
                      report.level,
                      LoadLevel());
    report.contact   = summarize(run.contact.ground(), run.state, loads);
    report.footprint = find_footprint(run.contact.ground(), run.state, loads);
    for (const auto &pair : run.contact.pairs)
      if (pair.get() != &run.contact.ground())
        if (const PlacedBody *placed = pair->body(loads))
          report.bodies[pair->name] = {summarize(*pair, run.state, loads),
                                       placed->body.displacement_of_point(),
                                       placed->body.rotation_vector()};
  }


  namespace
  {
    /** The stiffness of the last step, if the ground alone has moved.
     * @param before what it exerted before the step. */
    std::optional<StepStiffness>
    stiffness(const StageRun &run, const std::optional<GroundReaction> &before)
    {
      const Progress &progress = run.progress;
      const auto     &first    = progress.first_reaction;
      if (!first || !before || run.changes_penalty_stiffness())
        return {};
      const LoadLevel &now = progress.reaction->level;
      // the pressure of a sealed gas follows from the motion
      if (now.factors != first->level.factors ||
          (now.pressure != first->level.pressure && !run.stage.sealed))
        return {};

      const Tensor<1, 3> outward =
        run.contact.ground().moving_body.at_rest().direction();
      const Point<3> center = progress.first_contact_point +
                              first->level.slide -
                              first->level.travel * outward;
      const auto secant =
        stiffness_against_ground(*first, *progress.reaction, outward, center);
      const auto tangent =
        stiffness_against_ground(*before, *progress.reaction, outward, center);
      if (!secant || !tangent)
        return {};
      return StepStiffness{*first, *secant, *tangent};
    }
  } // namespace


  StepReport
  report_step(const StageRun                           &run,
              const Loads                              &loads,
              const std::shared_ptr<const NodalForces> &forces)
  {
    Progress  &progress = run.progress;
    StepReport report;
    report.step       = progress.n_steps;
    report.instant    = run.instant();
    report.stage      = run.stage.name;
    report.in_contact = run.stage.contact;
    report.work       = progress.work;
    report_contact(run, loads, report);
    report.forces = forces;
    report.forces_of_bodies =
      forces_on_shell(run.equations, run.state, *forces);
    report.controlled                          = run.control->controlled();
    const std::optional<GroundReaction> before = progress.reaction;
    progress.reaction.reset();
    if (run.stage.contact)
      {
        const ForceOnShell &now = force_of_ground(report.forces_of_bodies);
        progress.reaction       = {progress.reached, now.force, now.moment};
        report.stiffness        = stiffness(run, before);
      }
    const MovingReactions reactions = moving_reactions(
      run.equations, progress.reached, loads, report.forces_of_bodies);
    report.stiffness_of_motions = stiffness_of_motions(run, reactions);
    progress.reactions          = reactions;
    return report;
  }
} // namespace Biface
