// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/supports.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Whether a support of an edge of alpha_1 of a surface of revolution keeps
     * the radius of a face there. */
    bool
    holds_radius(const std::vector<SupportCondition> &support,
                 const Resultants::Face               face)
    {
      std::set<Component> held;
      for (const SupportCondition &condition : support)
        // not the mean or the difference of the faces
        if (condition.coefficients[face] != 0 &&
            condition.coefficients[1 - face] == 0 && condition.value == 0 &&
            !condition.formula)
          held.insert(condition.component);
      const auto holds = [&](const std::vector<Component> &components) {
        return std::all_of(
          components.begin(), components.end(), [&](const Component c) {
            return held.count(c) > 0;
          });
      };
      return holds({Component::radial}) ||
             holds({Component::x, Component::z}) ||
             holds({Component::v_1, Component::v_3});
    }
  } // namespace


  void
  Parameters::check_gas() const
  {
    const bool revolution =
      surface.type == ReferenceSurface::Parameters::Type::revolution;
    gas.check(revolution ||
              surface.type == ReferenceSurface::Parameters::Type::mesh);
    if (!pressure.end_plates.empty())
      {
        const auto refuse = [this](const std::string &why) {
          std::string text;
          for (const Edge edge : pressure.end_plates)
            text += (text.empty() ? "" : ", ") +
                    edge_names[static_cast<unsigned int>(edge)];
          throw InputError("Loads/End plates", text, why);
        };
        if (!revolution)
          refuse("it needs 'Surface/Type = surface of revolution'");
        if (!pressure.is_uniform())
          refuse("it needs 'Pressure distribution = 1'");
        // the area of a plate is that of the undeformed edge, section 5
        for (const Edge edge : pressure.end_plates)
          if (!holds_radius(supports.edges[static_cast<unsigned int>(edge)],
                            pressure.face))
            refuse("the plate needs a support of its edge in the section "
                   "'Supports' that keeps the radius of the face under "
                   "pressure, such as 'radial both'");
        if (gas.ambient_pressure && gas.cavity.rim_radius.value_or(0) != 0)
          refuse("the cavity reaches to the axis: 'Gas/Rim radius' must be 0 "
                 "or 'edges'");
      }

    // the pressures at the ends of the stages
    std::vector<double> ends;
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const auto        position = stage_before(stages, i);
        const double      before   = (position ? ends[*position] : 0.);
        const std::string section  = "Stage " + std::to_string(i + 1);
        if (stages[i].sealed)
          {
            if (stages[i].pressure)
              throw InputError(section + "/Pressure",
                               number_to_string(*stages[i].pressure),
                               "it must be 'unchanged' in a stage with 'Gas = "
                               "sealed', where the pressure follows from the "
                               "volume");
            if (stages[i].theory == StrainTheory::linear)
              throw InputError(section + "/Strain theory",
                               "linear",
                               "a stage with 'Gas = sealed' must be nonlinear");
            if (!gas.ambient_pressure)
              throw InputError(
                section + "/Gas", "sealed", "it needs 'Gas/Ambient pressure'");
            if (!(before + *gas.ambient_pressure > 0))
              throw InputError(
                section + "/Gas",
                "sealed",
                "it needs a positive absolute pressure, and before the "
                "stage the pressure is " +
                  number_to_string(before) + ", the ambient pressure " +
                  number_to_string(*gas.ambient_pressure));
            if (!pressure.is_uniform())
              throw InputError("Loads/Pressure distribution",
                               pressure.distribution.get_text(),
                               "it must be 1 with 'Gas = sealed': the pressure "
                               "of a gas is the same everywhere");
          }
        ends.push_back(stages[i].pressure.value_or(before));
      }
    if (gas.air.sound_speed)
      check_air(ends);
  }


  void
  Parameters::check_air(const std::vector<double> &pressures) const
  {
    const auto refuse = [this](const bool wrong, const std::string &why) {
      if (wrong)
        throw InputError("Gas/Sound speed",
                         number_to_string(*gas.air.sound_speed),
                         "it must be 'none' " + why);
    };
    refuse(surface.type != ReferenceSurface::Parameters::Type::revolution,
           "unless 'Surface/Type = surface of revolution'");
    refuse(supports.is_cyclic(),
           "for a sector with cyclic edges, of which the waves go around the "
           "whole");
    // edges of alpha_2, as in Edge
    refuse(!mesh.closed &&
             (!supports.is_symmetric(2) || !supports.is_symmetric(3)),
           "unless the shell is closed around or its edges of alpha_2 are "
           "planes of symmetry");
    refuse(has_inertia(),
           "with 'Inertia = true', where the pressure of the gas is the same "
           "everywhere");
    const std::vector<bool> rolls = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      if (stages[i].n_modes > 0 || stages[i].vibrates())
        {
          refuse(rolls[i],
                 "with 'Modes' or a 'Frequency response' where the wheel rolls "
                 "or spins");
          refuse(!sensitivities.entries.empty(),
                 "with 'Sensitivities' and 'Modes' or a 'Frequency response'");
          if (!stages[i].sealed && !(pressures[i] + *gas.ambient_pressure > 0))
            throw InputError("Gas/Ambient pressure",
                             number_to_string(*gas.ambient_pressure),
                             "with 'Sound speed' the absolute pressure must be "
                             "positive, and in stage " +
                               std::to_string(i + 1) + " the pressure is " +
                               number_to_string(pressures[i]));
        }
  }
} // namespace Biface
