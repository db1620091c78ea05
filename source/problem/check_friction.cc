// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/contact/friction.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/stage_sequence.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Check the coefficient of friction and the glue of a stage. */
    void
    check_entries(const std::vector<Stage> &stages, const unsigned int i)
    {
      const Stage      &stage   = stages[i];
      const std::string section = "Stage " + std::to_string(i + 1);
      if (stage.laws.friction && !stage.contact)
        throw InputError(section + "/Friction",
                         stage.laws.friction->get_text(),
                         "it needs 'Contact = true'");
      if (!stage.laws.glued)
        return;
      if (!stage.contact)
        throw InputError(
          section + "/Glued", "true", "it needs 'Contact = true'");
      const auto before = continued_stage(stages, i);
      if (!before || !stages[*before].contact)
        throw InputError(section + "/Glued",
                         "true",
                         "the stage from which it starts must have 'Contact "
                         "= true', since the nodes in contact at its end "
                         "are glued");
    }


    /** Check the stiffnesses of contact of a stage. */
    void
    check_stiffness(const std::vector<Stage> &stages, const unsigned int i)
    {
      const Stage      &stage   = stages[i];
      const std::string section = "Stage " + std::to_string(i + 1) + "/";
      const auto        check   = [&](const std::string           &entry,
                             const std::optional<double> &stiffness) {
        if (!stiffness)
          return;
        check_positive(section + entry, *stiffness);
        if (!stage.contact && stage.bodies.empty())
          throw InputError(section + entry,
                           number_to_string(*stiffness),
                           "it needs 'Contact = true' or 'Bodies'");
      };
      check("Regularization", stage.laws.penalty_stiffness);
      check("Tangential regularization", stage.laws.tangential_stiffness);

      // these controls do not know how far a step goes
      const auto before = continued_stage(stages, i);
      if (before &&
          (stage.control == ControlKind::displacement ||
           stage.control == ControlKind::arc_length) &&
          stages[*before].laws.penalty_stiffness !=
            stage.laws.penalty_stiffness)
        throw InputError(
          section + "Regularization",
          stage.laws.penalty_stiffness
            ? number_to_string(*stage.laws.penalty_stiffness)
            : "as in Contact",
          "with 'Control = " + stage.control_name() +
            "' it must be that of the stage from which it starts");
    }


    /** Check a stage that rolls on bristles. */
    void
    check_bristles(const Parameters &parameters, const unsigned int i)
    {
      const Stage              &stage       = parameters.stages[i];
      const std::string         section     = "Stage " + std::to_string(i + 1);
      const FrictionCoefficient coefficient = parameters.friction_in(stage);
      if (coefficient.depends_on_speed())
        throw InputError(stage.laws.friction ? section + "/Friction"
                                             : "Contact/Friction",
                         coefficient.get_text(),
                         "with 'Rolling friction = bristles' it must not "
                         "depend on the slip velocity s");
      if (stage.n_modes > 0)
        throw InputError(section + "/Modes",
                         std::to_string(stage.n_modes),
                         "it must be 0 where the wheel rolls with 'Rolling "
                         "friction = bristles'");
    }
  } // namespace


  FrictionCoefficient
  Parameters::friction_in(const Stage &stage) const
  {
    return stage.laws.friction ? *stage.laws.friction
                               : contact.friction.coefficient;
  }


  void
  Parameters::check_friction() const
  {
    const std::vector<bool> rolling = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage      &stage   = stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        check_entries(stages, i);
        check_stiffness(stages, i);
        // friction with history makes no more demands
        if (!rolling[i])
          continue;
        // no particle of a wheel that rolls stays in the footprint
        if (stage.laws.glued)
          throw InputError(section + "/Glued",
                           "true",
                           "it must be 'false' where the wheel rolls");
        if (!stage.contact || friction_in(stage).is_zero())
          continue;
        if (stage.locates_critical_points())
          throw InputError(section + "/Critical points",
                           stage.critical_points_name(),
                           "it must be 'ignore' or 'report' where the wheel "
                           "rolls with friction, whose tangent is not "
                           "symmetric");
        if (contact.friction.in_rolling == FrictionInRolling::bristles)
          check_bristles(*this, i);
        else if (contact.friction.critical_velocity == 0)
          throw InputError("Contact/Critical velocity",
                           "0",
                           "it must be positive for the friction of the wheel "
                           "that rolls in stage " +
                             std::to_string(i + 1));
        // tractions of neighbors would couple nodes for which the tangent has
        // no entries, section 10
        if (contact.condition.mortar_matrix != MortarMatrix::lumped)
          throw InputError("Contact/Multiplier mass",
                           "consistent",
                           "it must be 'lumped' for the friction of the wheel "
                           "that rolls in stage " +
                             std::to_string(i + 1));
      }
  }
} // namespace Biface
