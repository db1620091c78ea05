// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>

namespace Biface
{
  namespace
  {
    void
    check_excitation(const std::string                 &excitation,
                     const std::string                 &entry,
                     const Stage                       &stage,
                     const std::vector<BodyParameters> &all_bodies)
    {
      if (const auto motion = StageResponse::motion(excitation, stage))
        {
          std::vector<std::string> bodies = stage.bodies;
          if (stage.contact)
            bodies.insert(bodies.begin(), "ground");
          bodies.push_back("supports");
          std::string there;
          for (const std::string &body : bodies)
            there += ", '" + body + "'";
          if (std::find(bodies.begin(), bodies.end(), motion->first) ==
              bodies.end())
            throw InputError(entry,
                             excitation,
                             "what moves must be there in the stage: " +
                               there.substr(2));
          return;
        }
      if (excitation == "load factor" || excitation.rfind("bodies", 0) == 0)
        for (const BodyParameters &body : all_bodies)
          if (!body.motions.empty() &&
              std::find(stage.bodies.begin(), stage.bodies.end(), body.name) !=
                stage.bodies.end())
            throw InputError(entry,
                             excitation,
                             "it would move the body '" + body.name +
                               "'; name its motion '" + body.name +
                               " x', y or z, and other loads by their own "
                               "names");
      if (excitation == "pressure" && stage.sealed)
        throw InputError(entry,
                         excitation,
                         "with 'Gas = sealed' the pressure follows from the "
                         "volume");
    }
  } // namespace


  void
  Parameters::check_response() const
  {
    const std::vector<bool> rolls = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage &stage = stages[i];
        if (!stage.vibrates())
          continue;
        const std::string section = "Stage " + std::to_string(i + 1);
        const auto refuse = [&](const bool wrong, const std::string &why) {
          if (wrong)
            throw InputError(section + "/Frequency response",
                             number_to_string(stage.frequencies[0]),
                             "it must be empty " + why);
        };
        refuse(stage.inertia || stage.damping > 0,
               std::string("with '") +
                 (stage.inertia ? "Inertia = true" : "Damping") +
                 "', since the stage does not end in equilibrium");
        refuse(rolls[i] && !stage.bodies.empty(),
               "where a wheel rolls and touches other bodies than the ground");
        refuse(rolls[i] && stage.contact &&
                 contact.friction.in_rolling == FrictionInRolling::bristles,
               "where the wheel rolls with 'Rolling friction = bristles'");
        if (rolls[i])
          // materials that no ply has do not matter
          for (const PlyParameters &ply : laminate.plies)
            for (const MaterialParameters &material : materials)
              refuse(material.name == ply.material && material.relaxes(),
                     "where the wheel rolls or spins with the material '" +
                       material.name + "', whose stresses relax");
        for (const std::string &excitation : stage.excitations)
          check_excitation(excitation, section + "/Excitations", stage, bodies);
      }
  }
} // namespace Biface
