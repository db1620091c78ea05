// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_run_h
#define biface_stepping_stage_run_h

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <biface/contact/contact_laws.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/heat/rolling_heat.h>
#include <biface/stepping/controls/control.h>
#include <biface/stepping/instant.h>
#include <biface/stepping/progress.h>
#include <biface/stepping/stage.h>

namespace Biface
{
  class ContactInteraction;
  struct Loads;
  struct RollingStep;


  /**
   * A stage while a shell goes through it: its control, its loads at any level,
   * and the last converged equilibrium. LoadStepping computes the steps;
   * SensitivityAnalysis takes perturbed shells along.
   */
  class StageRun
  {
  public:
    /** Enter the current stage of the progress, which has started or not. The
     * objects, except the stages and parameters, are kept by reference. Throws
     * InputError if the friction of the stage is invalid.
     * @param progress, state of the last converged step. */
    StageRun(const std::vector<Stage>  &stages,
             const Control::Parameters &parameters,
             const ShellEquations      &equations,
             const ContactInteraction  &contact,
             const RollingHeat         *heat,
             Progress                  &progress,
             State                     &state);

    /**
     * Start the stage: return to the undeformed shape if it starts from a
     * prestress, find where the ground touches, glue the nodes in contact,
     * set the strain theory, and let force terms and control start.
     *
     * @return what is out of balance in a start from a prestress.
     */
    std::optional<ShellEquations::Unbalance>
    start();

    /** The loads at a level. */
    Loads
    loads_at(const LoadLevel &level) const;

    /** The loads at a level, with other laws of the ground.
     *
     * Where the penalty stiffness of a stage differs from that of the stage
     * before, its inverse changes evenly between both, and with it the
     * penetration. */
    Loads
    loads_at(const LoadLevel &level, const ContactLaws &laws) const;

    /** What passes between the last converged step and a level of this shell:
     * the time, and the temperature in it; a wheel that rolls has that of the
     * level. */
    TimeStep
    time_step_to(const LoadLevel &level) const;

    /** The step in which the bristles of a wheel move on from the last
     * converged one; null in steady rolling. */
    std::shared_ptr<const RollingStep>
    rolling_step(const double duration) const;

    /** The equilibrium from which the next step starts. */
    Control::Equilibrium
    last_converged() const;

    bool
    is_complete() const
    {
      return control->done() >= 1;
    }

    /** Whether the last converged step was one in time, so that its state is
     * not in equilibrium with the loads of this stage. */
    bool
    starts_from_motion() const
    {
      return control->done() == 0 && before && before->inertia;
    }

    /** The completed part of the stage. */
    Instant
    instant() const
    {
      return {progress.stage, control->done()};
    }

    const ShellEquations     &equations;
    const ContactInteraction &contact;
    /** The heat of the plies; null if no ply loses energy in rolling. */
    const RollingHeat *heat;
    Progress          &progress;
    State             &state;

    /** The description of the stage, see Progress::complete(), with the change
     * of the stiffness of contact. */
    const Stage stage;
    /** The stage whose contact this one continues; none if it starts
     * undeformed.
     */
    const std::optional<Stage>     before;
    const std::unique_ptr<Control> control;
    /** Whether the shell rolls in the stage, see Stage::rolls(). */
    const bool rolls;
    /** The laws of the ground, if there is one, at the end of the stage. */
    const ContactLaws laws;
    /** The laws of the bodies that are there, by ContactPair::number. */
    const std::map<unsigned int, ContactLaws> laws_of_bodies;

  private:
    /** The laws of a pair at a level. */
    ContactLaws
    at_level(const LoadLevel   &level,
             const unsigned int number,
             const ContactLaws &at_end) const;

    /** The place of the ground, or of a body on it, after the motions of
     * the ground.
     * @param body after its travel or its own motions.
     * @param travel what is left of the travel. */
    RigidBody
    with_ground(const RigidBody &body, const LoadLevel &level) const;

    /** Throws InputError if the shell is deep in a body. */
    void
    check_bodies() const;

    /** Let nodes that stick keep their tractions where the stage has another
     * tangential stiffness than the stage before. */
    void
    keep_tangential_tractions() const;

    Loads
    loads_without_contact(const LoadLevel &level) const;

    ShellEquations::Unbalance
    start_from_prestress();

    /** Note the reactions from which the stiffnesses of the stage count.
     * @param ground_is_placed whether the ground just touches the shell. */
    void
    note_first_reactions(const bool ground_is_placed);
  };
} // namespace Biface

#endif
