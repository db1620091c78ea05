// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <string>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/controls/make_control.h>
#include <biface/stepping/stage_run.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::map<unsigned int, std::shared_ptr<const TangentialLaw>>
    make_laws_of_bodies(const ContactInteraction &contact, const Stage &stage)
    {
      std::map<unsigned int, std::shared_ptr<const TangentialLaw>> laws;
      for (const auto &pair : contact.pairs)
        if (pair.get() != &contact.ground() &&
            std::find(stage.bodies.begin(), stage.bodies.end(), pair->name) !=
              stage.bodies.end())
          laws[pair->number] =
            pair->law("Body " + pair->name + "/Friction", "", false, false);
      return laws;
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
    , stage(progress.complete(stages[progress.stage]))
    , control(make_control(stage, parameters))
    , rolls(stage.rolls(progress.stage_begun ? progress.control.start
                                             : progress.reached))
    , law(contact.ground().law("Stage " + std::to_string(progress.stage + 1) +
                                 "/Friction",
                               stage.friction,
                               stage.glued,
                               rolls))
    , laws_of_bodies(make_laws_of_bodies(contact, stage))
  {
    if (progress.stage_begun)
      control->restore(progress.control);
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
    if (rolls)
      loads.rolling = Rolling{level.angular_velocity};
    return loads;
  }


  RigidBody
  StageRun::with_foundation(const RigidBody &body, const LoadLevel &level) const
  {
    // the wheel turns about its axle whatever its inclination
    const Tensor<1, 3> axle({0., 1., 0.});
    const Tensor<1, 3> direction = contact.ground().body_at(0).direction();
    RigidBody          placed    = body.displaced(level.slide,
                                      level.turn * numbers::PI / 180,
                                      progress.touched_point,
                                      direction);
    if (level.inclination_angle != 0)
      placed = placed.around(WheelAxes(direction).forward,
                             -level.inclination_angle * numbers::PI / 180);
    return placed.around(axle, -level.wheel_turn * numbers::PI / 180);
  }


  Loads
  StageRun::loads_at(const LoadLevel                            &level,
                     const std::shared_ptr<const TangentialLaw> &law) const
  {
    Loads loads = loads_without_contact(level);
    if (stage.contact)
      {
        const double    slip_angle = level.slip_angle * numbers::PI / 180;
        const RigidBody ground     = with_foundation(
          on_steered(
            contact.ground().body_at(*progress.touching_travel + level.travel),
            slip_angle),
          level);
        loads.place(0, {ground, law});
        if (loads.rolling)
          loads.rolling->ground = GroundMotion::under_wheel(
            ground, level.ground_velocity, slip_angle);
      }
    for (const auto &[number, law_of_body] : laws_of_bodies)
      {
        const ContactPair &pair = *contact.pairs[number];
        loads.place(
          number,
          {pair.body_at(level.factors,
                        [&](const RigidBody &body) {
                          return with_foundation(
                            contact.ground().taken_along(
                              body, *progress.touching_travel + level.travel),
                            level);
                        }),
           law_of_body,
           pair.face,
           pair.name});
      }
    return loads;
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
    for_each_motion([](auto &motion, const auto &zero) { motion = zero; },
                    progress.reached,
                    LoadLevel());
    progress.work             = Work();
    progress.factors_of_shape = progress.reached.factors;
    progress.touching_travel.reset();
    progress.reaction.reset();
    progress.last_change.clear();
    return equations.start_from_prestress(
      state, loads_without_contact(progress.reached));
  }


  void
  StageRun::check_bodies() const
  {
    const Loads loads = loads_at(progress.reached);
    for (const auto &item : laws_of_bodies)
      {
        const ContactPair &pair  = *contact.pairs[item.first];
        const double       depth = pair.penetration(state, loads);
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


  std::optional<ShellEquations::Unbalance>
  StageRun::start()
  {
    progress.reached = with_factors(progress.reached, stage.factors.size());
    if (progress.stage == 0)
      progress.reached.temperature = stage.temperature.value_or(0);
    std::optional<ShellEquations::Unbalance> unbalance;
    if (stage.from_prestress)
      unbalance = start_from_prestress();
    if (stage.contact && !progress.touching_travel)
      {
        progress.touching_travel = contact.ground().touching_travel(state);
        progress.touched_point =
          contact.ground().touched_point(state, *progress.touching_travel);
        progress.reaction = {progress.reached, {}, {}};
      }
    progress.first_reaction = progress.reaction;
    InternalForces::set_theory(stage.theory, state);
    check_bodies();
    equations.start_stage(loads_at(progress.reached), state);

    control->begin(last_converged());
    progress.control = control->get_memory();
    progress.predictor.reset();
    progress.stage_begun = true;
    return unbalance;
  }
} // namespace Biface
