// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <biface/stepping/stage_start.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    Loads
    loads_without_foundation(const LoadLevel &level,
                             const bool       rolls,
                             const Progress  &progress)
    {
      Loads loads;
      // that of a sealed gas changes only with the state
      loads.pressure =
        (progress.gas_content ? progress.reached.pressure : level.pressure);
      loads.factor          = level.factor;
      loads.factor_of_shape = progress.factor_of_shape;
      if (rolls)
        loads.rolling = Rolling{level.angular_velocity};
      return loads;
    }
  } // namespace


  Loads
  loads_at(const LoadLevel                          &level,
           const Stage                              &stage,
           const bool                                rolls,
           const std::shared_ptr<const FrictionLaw> &friction,
           const ContactInteraction                 &contact,
           const Progress                           &progress)
  {
    Loads loads = loads_without_foundation(level, rolls, progress);
    if (stage.contact)
      {
        const double slip_angle = level.slip_angle * numbers::PI / 180;
        loads.foundation =
          on_steered(
            contact.foundation(*progress.touching_travel + level.travel),
            slip_angle)
            .displaced(level.slide,
                       level.turn * numbers::PI / 180,
                       progress.touched_point)
            .around(-level.wheel_turn * numbers::PI / 180);
        loads.friction = friction;
        if (loads.rolling)
          loads.rolling->ground = GroundMotion::under_wheel(
            *loads.foundation, level.ground_velocity, slip_angle);
      }
    return loads;
  }


  namespace
  {
    ShellEquations::Unbalance
    start_from_prestress(const bool      rolls,
                         ShellEquations &equations,
                         Progress       &progress,
                         State          &state)
    {
      for_each_motion([](auto &motion, const auto &zero) { motion = zero; },
                      progress.reached,
                      LoadLevel());
      progress.work            = Work();
      progress.factor_of_shape = progress.reached.factor;
      progress.touching_travel.reset();
      progress.reaction.reset();
      progress.last_change.clear();
      return equations.start_from_prestress(
        state, loads_without_foundation(progress.reached, rolls, progress));
    }
  } // namespace


  std::optional<ShellEquations::Unbalance>
  start_stage(const Stage              &stage,
              const bool                rolls,
              ShellEquations           &equations,
              const ContactInteraction &contact,
              const Gas                *gas,
              Progress                 &progress,
              State                    &state)
  {
    std::optional<ShellEquations::Unbalance> unbalance;
    if (stage.from_prestress)
      unbalance = start_from_prestress(rolls, equations, progress, state);
    if (stage.contact && !progress.touching_travel)
      {
        progress.touching_travel = contact.touching_travel(state);
        progress.touched_point =
          contact.touched_point(state, *progress.touching_travel);
        progress.reaction = {progress.reached, {}, {}};
      }
    progress.first_reaction = progress.reaction;
    if (rolls)
      contact.forget_history(state);
    contact.set_glued(state, stage.glued);
    equations.internal_forces().set_theory(stage.theory, state);
    progress.gas_content.reset();
    if (stage.sealed)
      progress.gas_content = gas->content(progress.reached.pressure, state);
    return unbalance;
  }
} // namespace Biface
