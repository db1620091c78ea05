// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include <biface/base/errors.h>
#include <biface/contact/rolling.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/contact/approach.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/moving_mass.h>
#include <biface/model/state/placed_body.h>
#include <biface/model/state/rolling_step.h>
#include <biface/model/time/inertia.h>
#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/start_motion.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    bool
    has_body(const Stage &stage, const ContactPair &pair)
    {
      return pair.number == 0 ? stage.contact
                              : std::find(stage.bodies.begin(),
                                          stage.bodies.end(),
                                          pair.name) != stage.bodies.end();
    }


    /** What a stage sets for a pair: the coefficient of friction and the glue
     * are those of the ground. */
    ContactLawsOfStage
    set_for(const ContactPair &pair, const Stage &stage)
    {
      ContactLawsOfStage laws = stage.laws;
      if (pair.number > 0)
        {
          laws.friction.reset();
          laws.glued = false;
        }
      return laws;
    }


    std::map<unsigned int, ContactLaws>
    make_laws_of_bodies(const ContactInteraction &contact, const Stage &stage)
    {
      std::map<unsigned int, ContactLaws> laws;
      for (const auto &pair : contact.pairs)
        if (pair.get() != &contact.ground() && has_body(stage, *pair))
          laws.emplace(pair->number, pair->laws(set_for(*pair, stage)));
      return laws;
    }


    /** The stage whose contact a stage continues; from prestress, contact
     * starts anew. */
    std::optional<Stage>
    before_in(const std::vector<Stage> &stages, const unsigned int position)
    {
      const auto before = continued_stage(stages, position);
      if (!before)
        return {};
      return stages[*before];
    }


    /** A stage with the level of the stiffness of contact at its end. */
    Stage
    with_change_of_stiffness(Stage                       stage,
                             const std::optional<Stage> &before,
                             const LoadLevel            &start)
    {
      if (before &&
          before->laws.penalty_stiffness != stage.laws.penalty_stiffness)
        stage.changes_of_stiffness = start.changes_of_stiffness + 1;
      return stage;
    }
  } // namespace


  StageRun::StageRun(const std::vector<Stage>  &stages,
                     const Control::Parameters &parameters,
                     const ShellEquations      &equations,
                     const ContactInteraction  &contact,
                     const RollingHeat         *heat,
                     Progress                  &progress,
                     State                     &state)
    : equations(equations)
    , contact(contact)
    , heat(heat)
    , progress(progress)
    , state(state)
    , stage(with_change_of_stiffness(progress.complete(stages[progress.stage]),
                                     before_in(stages, progress.stage),
                                     progress.start_of_stage()))
    , before(before_in(stages, progress.stage))
    , control(make_control(stage, parameters))
    , rolls(stage.rolls(progress.start_of_stage()))
    , laws(contact.ground().laws(stage.laws, rolls))
    , laws_of_bodies(make_laws_of_bodies(contact, stage))
  {
    if (progress.stage_begun)
      control->restore(progress.control);

    // the bristles that the state has, whether it was just computed or read
    // from a checkpoint: those of a step in which nothing moves
    const bool has_past = progress.stage_begun
                            ? stage.transient_rolling
                            : before && before->transient_rolling;
    state.rolling_step.reset();
    if (has_past && rolls && stage.contact)
      state.rolling_step = std::make_shared<const RollingStep>(RollingStep{
        state.displacement, state.contacts, loads_at(progress.reached)});
  }


  std::shared_ptr<const RollingStep>
  StageRun::rolling_step(const double duration) const
  {
    if (!stage.transient_rolling)
      return nullptr;
    return std::make_shared<const RollingStep>(
      RollingStep{state.displacement,
                  state.contacts,
                  loads_at(progress.reached),
                  duration,
                  stage.inertia || !stage.prescribes_axle_moment()});
  }


  Loads
  StageRun::loads_without_contact(const LoadLevel &level) const
  {
    Loads loads;
    // the pressure of a sealed gas changes only with the state
    loads.sealed_gas = stage.sealed;
    loads.damping    = stage.damping;
    loads.pressure =
      (stage.sealed ? progress.reached.pressure : level.pressure);
    loads.factors          = level.factors;
    loads.factors_of_shape = progress.factors_of_shape;
    // products of a change of loads and one of the shape are of second order:
    // what follows the shell turns with its size at the start, section 5
    if (stage.theory == StrainTheory::linear)
      {
        const LoadLevel &start = progress.start_of_stage();
        loads.linearized_at    = LoadRates{start.pressure, start.factors};
      }
    if (rolls)
      loads.rolling =
        std::make_shared<const Rolling>(Rolling{level.angular_velocity});
    return loads;
  }


  RigidBody
  StageRun::with_ground(const RigidBody &body, const LoadLevel &level) const
  {
    // the wheel turns about its axle whatever its inclination
    const Tensor<1, 3> axle({0., 1., 0.});
    const Tensor<1, 3> direction =
      contact.ground().moving_body.at_rest().direction();
    RigidBody placed = body.displaced(level.slide,
                                      level.turn * numbers::PI / 180,
                                      progress.first_contact_point,
                                      direction);
    // results are in the axes of the wheel: the ground leans and turns the
    // other way
    if (level.inclination_angle != 0)
      placed = placed.rotated(WheelAxes(direction).forward,
                              -level.inclination_angle * numbers::PI / 180);
    return placed.rotated(axle, -level.wheel_turn * numbers::PI / 180);
  }


  ContactLaws
  StageRun::at_level(const LoadLevel   &level,
                     const unsigned int number,
                     const ContactLaws &at_end) const
  {
    const ContactPair &pair = *contact.pairs[number];
    // at the end of the stage, or where nothing changes
    const double left =
      (stage.changes_of_stiffness
         ? *stage.changes_of_stiffness - level.changes_of_stiffness
         : 0.);
    if (!(left > 0) || !before || !has_body(*before, pair))
      return at_end;
    const double start =
      pair.laws(set_for(pair, *before)).condition().penalty_stiffness();
    const double end = at_end.condition().penalty_stiffness();
    // 1/stiffness changes evenly, and with it the penetration of a pressure,
    // section 7
    return at_end.with_condition(ContactCondition(
      left < 1 ? 1 / (left / start + (1 - left) / end) : start));
  }


  Loads
  StageRun::loads_at(const LoadLevel &level) const
  {
    return loads_at(level, laws);
  }


  Loads
  StageRun::loads_at(const LoadLevel &level, const ContactLaws &laws) const
  {
    Loads loads = loads_without_contact(level);
    if (stage.contact)
      {
        const double    slip_angle = level.slip_angle * numbers::PI / 180;
        const RigidBody ground =
          with_ground(ground_at_slip_angle(
                        contact.ground().moving_body.after_travel(
                          *progress.travel_at_first_contact + level.travel),
                        slip_angle),
                      level);
        loads.place(0, {ground, at_level(level, 0, laws)});
        // the ground moves under a wheel that stands in the frame of the axle,
        // section 10
        if (loads.rolling)
          {
            Rolling rolling = *loads.rolling;
            rolling.ground  = GroundMotion::under_wheel(
              ground, level.ground_velocity, slip_angle);
            loads.rolling = std::make_shared<const Rolling>(rolling);
          }
      }
    for (const auto &[number, laws_of_body] : laws_of_bodies)
      {
        const ContactPair &pair = *contact.pairs[number];
        loads.place(
          number,
          {pair.moving_body.after_motions(
             level.factors,
             [&](const RigidBody &body) {
               return with_ground(
                 contact.ground().moving_body.carried_by(
                   body, *progress.travel_at_first_contact + level.travel),
                 level);
             }),
           at_level(level, number, laws_of_body),
           pair.face,
           pair.name});
      }
    return loads;
  }


  TimeStep
  StageRun::time_step_to(const LoadLevel &level) const
  {
    // steady rolling has no time before: all of a turn relaxes at the
    // temperature of the level; in time, a step does at its mean one
    const LoadLevel &from = progress.reached;
    return {level.time - from.time,
            rolls ? level.temperature
                  : (from.temperature + level.temperature) / 2};
  }


  Control::Equilibrium
  StageRun::last_converged() const
  {
    return {equations,
            contact,
            state,
            progress.reached,
            progress.last_change,
            [this](const LoadLevel &level) { return loads_at(level); }};
  }


  ShellEquations::Unbalance
  StageRun::start_from_prestress()
  {
    // the shape that was reached counts as undeformed, section 5: motions, work
    // and contact start from zero, while the loads are kept
    for_each_motion([](auto &motion, const auto &zero) { motion = zero; },
                    progress.reached,
                    LoadLevel());
    progress.work             = Work();
    progress.factors_of_shape = progress.reached.factors;
    progress.travel_at_first_contact.reset();
    progress.last_change.clear();
    return equations.start_from_prestress(
      state, loads_without_contact(progress.reached));
  }


  void
  StageRun::check_bodies() const
  {
    // the penetration is there before the first step, so that halving it would
    // not help
    const Loads loads = loads_at(progress.reached);
    for (const auto &item : laws_of_bodies)
      {
        const ContactPair &pair  = *contact.pairs[item.first];
        const double       depth = penetration(pair, state, loads);
        if (depth > contact.mesh.thickness())
          throw InputError(
            "Stage " + std::to_string(progress.stage + 1) + "/Bodies",
            pair.name,
            "at the start of the stage the shell is inside this body, by " +
              number_to_string(depth) +
              ", more than its thickness; let the body start outside and move "
              "it by 'Load factors'");
      }
  }


  void
  StageRun::note_first_reactions(const bool ground_is_placed)
  {
    if (progress.reactions)
      progress.first_reactions = *progress.reactions;
    progress.reactions.reset();
    // displacements count from here, and nothing reacts but to a prestress
    if (stage.from_prestress || progress.n_steps == 0)
      {
        MovingReaction at_rest;
        if (stage.from_prestress)
          at_rest.force[0] = std::numeric_limits<double>::quiet_NaN();
        progress.first_reactions = {progress.reached, {}};
        for (const SupportMotion &motion : equations.mesh.supported.motions)
          progress.first_reactions.of[motion.name] = at_rest;
      }
    const Loads loads = loads_at(progress.reached);
    for (const ContactPair *pair : contact.present(loads))
      if (progress.first_reactions.of.count(pair->name) == 0 &&
          ((pair == &contact.ground() && ground_is_placed) ||
           !(penetration(*pair, state, loads) > 0)))
        progress.first_reactions.of[pair->name] =
          without_force(*pair->body(loads));
  }


  void
  StageRun::keep_tangential_tractions() const
  {
    if (!before ||
        before->laws.tangential_stiffness == stage.laws.tangential_stiffness)
      return;
    // stick points move so that sticking nodes keep their tractions under
    // another stiffness, and the stage starts in equilibrium, section 7
    const Loads loads = loads_at(progress.reached);
    for (const auto &pair : contact.pairs)
      if (has_body(stage, *pair) && has_body(*before, *pair))
        pair->keep_tangential_tractions(
          state,
          loads,
          pair->tangential_stiffness(before->laws) /
            pair->tangential_stiffness(stage.laws));
  }


  std::optional<ShellEquations::Unbalance>
  StageRun::start()
  {
    progress.reached = with_factors(progress.reached, stage.factors.size());
    // without a stage before, the temperature is constant in the first one
    if (progress.stage == 0)
      progress.reached.temperature = stage.temperature.value_or(0);
    std::optional<ShellEquations::Unbalance> unbalance;
    if (stage.from_prestress)
      unbalance = start_from_prestress();
    // travel counts from where the ground meets the shell as it is here, such
    // as after inflation; stages that follow keep this place
    const bool ground_is_placed =
      stage.contact && !progress.travel_at_first_contact;
    if (ground_is_placed)
      {
        progress.travel_at_first_contact =
          travel_at_first_contact(contact.ground(), state);
        progress.first_contact_point = first_contact_point(
          contact.ground(), state, *progress.travel_at_first_contact);
      }
    InternalForces::set_theory(stage.theory, state);
    check_bodies();
    note_first_reactions(ground_is_placed);
    keep_tangential_tractions();
    equations.start_stage(loads_at(progress.reached), state);

    control->begin(last_converged());
    // what steps in time remember counts from the start of the stage
    state.terms.erase(Inertia::body);
    if (stage.inertia)
      {
        const Control::Trial first = control->propose(last_converged());
        const LoadLevel      after = first.within(1);
        start_motion(equations,
                     stage,
                     "Stage " + std::to_string(progress.stage + 1),
                     {loads_at(progress.reached),
                      loads_at(first.within(0.5)),
                      loads_at(after),
                      after.time - progress.reached.time},
                     state);
      }
    else
      {
        state.velocity.clear();
        MovingMass::bring_to_rest(state);
      }
    progress.control = control->get_memory();
    progress.predictor.reset();
    progress.stage_begun = true;
    return unbalance;
  }
} // namespace Biface
