// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/program/parameters.h>
#include <biface/stepping/stage_sequence.h>

namespace Biface
{
  using namespace dealii;

  void
  Parameters::check_gas() const
  {
    const bool revolution =
      surface.type == ReferenceSurface::Parameters::Type::revolution;
    gas.check(revolution);
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
        for (const Edge edge : pressure.end_plates)
          if (supports.edges[static_cast<unsigned int>(edge)].empty())
            refuse("the plate needs a support of its edge in the section "
                   "'Supports', which holds at least the radius");
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
  }
} // namespace Biface
