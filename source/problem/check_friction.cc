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
      if (!stage.friction.empty())
        {
          Biface::check_friction(section + "/Friction", stage.friction);
          if (!stage.contact)
            throw InputError(section + "/Friction",
                             stage.friction,
                             "it needs 'Contact = true'");
        }
      if (!stage.glued)
        return;
      if (!stage.contact)
        throw InputError(
          section + "/Glued", "true", "it needs 'Contact = true'");
      const auto before = stage_before(stages, i);
      if (!before || !stages[*before].contact || stage.from_prestress)
        throw InputError(section + "/Glued",
                         "true",
                         "the stage from which it starts must have 'Contact "
                         "= true', since the nodes in contact at its end "
                         "are glued");
    }


    /** Check a stage that rolls on bristles. */
    void
    check_bristles(const Parameters &parameters, const unsigned int i)
    {
      const Stage      &stage   = parameters.stages[i];
      const std::string section = "Stage " + std::to_string(i + 1);
      const std::string entry   = section + "/Friction";
      const FrictionLaw law =
        parameters.contact.friction.of_stage(entry, stage.friction);
      if (law.depends_on_speed())
        throw InputError(stage.friction.empty() ? "Contact/Friction" : entry,
                         stage.friction.empty()
                           ? parameters.contact.friction.coefficient
                           : stage.friction,
                         "with 'Rolling friction = bristles' it must not "
                         "depend on the slip velocity s");
      if (stage.n_modes > 0)
        throw InputError(section + "/Modes",
                         std::to_string(stage.n_modes),
                         "it must be 0 where the wheel rolls with 'Rolling "
                         "friction = bristles'");
    }
  } // namespace


  void
  Parameters::check_friction() const
  {
    const std::vector<bool> rolling = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage      &stage   = stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        check_entries(stages, i);
        // friction with history makes no more demands
        if (!rolling[i])
          continue;
        if (stage.glued)
          throw InputError(section + "/Glued",
                           "true",
                           "it must be 'false' where the wheel rolls");
        if (!stage.contact ||
            contact.friction.of_stage(section + "/Friction", stage.friction)
              .is_zero())
          continue;
        if (stage.locates_critical_points())
          throw InputError(section + "/Critical points",
                           stage.critical_points_name(),
                           "it must be 'ignore' or 'report' where the wheel "
                           "rolls with friction, whose tangent is not "
                           "symmetric");
        if (contact.friction.rolling == RollingFriction::bristles)
          check_bristles(*this, i);
        else if (contact.friction.critical_velocity == 0)
          throw InputError("Contact/Critical velocity",
                           "0",
                           "it must be positive for the friction of the wheel "
                           "that rolls in stage " +
                             std::to_string(i + 1));
        if (contact.condition.mass != MultiplierMass::lumped)
          throw InputError("Contact/Multiplier mass",
                           "consistent",
                           "it must be 'lumped' for the friction of the wheel "
                           "that rolls in stage " +
                             std::to_string(i + 1));
      }
  }
} // namespace Biface
