// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/footprint.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/loads.h>
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
    for (const ContactPair *pair : run.contact.present(loads))
      if (pair != &run.contact.ground())
        {
          const RigidBody &body     = pair->body(loads)->body;
          report.bodies[pair->name] = {summarize(*pair, run.state, loads),
                                       body.displacement_of_point(),
                                       body.rotation_vector()};
        }
  }


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
    report.controlled               = run.control->controlled();
    const MovingReactions reactions = moving_reactions(
      run.equations, progress.reached, loads, report.forces_of_bodies);
    report.stiffness   = stiffness_of_motions(run, reactions);
    progress.reactions = reactions;
    return report;
  }
} // namespace Biface
