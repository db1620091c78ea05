// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/sensitivity_parameters.h>

namespace Biface
{
  using namespace dealii;

  void
  SensitivityParameters::add_parameters(EntryDeclarations &prm)
  {
    // as texts, which have a meaning only when the whole file is known
    prm.add_parameter("Entries",
                      entries,
                      "Numbers of this file by which derivatives are computed, "
                      "separated by semicolons: 'Stage 1/Pressure; E: Material "
                      "cord/E_L; angle: Laminate/Plies[2], -Laminate/Plies[4]; "
                      "stiffness: factor of Material cord/E_L, Material "
                      "cord/E_T'. [k] is the k-th number in the value of an "
                      "entry; several numbers vary together, those with a "
                      "minus with the opposite sign. Empty for none.",
                      Patterns::Anything());
    prm.add_parameter(
      "Outputs",
      outputs,
      "The results whose derivatives are computed, separated "
      "by commas: columns of history.csv such as 'force', "
      "displacements of named points such as 'top u_x' or "
      "'top inner u_x', forces of forces.csv such as 'alpha_1 "
      "min F_x', stiffnesses of the ground, a body or a "
      "support that moves such as 'foundation tangent' or "
      "'alpha_1 max secant', from the step before or the start "
      "of the stage, frequencies of a stage with 'Modes' such as "
      "'frequency 1', factors of a stage with 'Buckling' such "
      "as 'buckling factor 1'.",
      Patterns::List(Patterns::Anything()));
    prm.add_parameter("Stages",
                      stages,
                      "Numbers of the stages at whose ends derivatives are "
                      "computed, separated by commas; empty for the last "
                      "stage.",
                      Patterns::List(Patterns::Integer(1, 1000)));
    add_optional_number(
      prm,
      "Relative step",
      step,
      "automatic",
      "The change of an entry in differences, in parts of its value, from 1e-8 "
      "to 0.1; for an entry that is 0, the change itself. 'automatic': 1e-4, for "
      "entries of the sections Surface and Mesh, and with friction, 2e-5; an "
      "entry that is 0 and has a unit other than degrees needs a number.",
      Unit::none());
  }


  void
  SensitivityParameters::check(const unsigned int n_stages) const
  {
    if (step)
      {
        // smaller changes are lost in round-off
        check_at_least("Sensitivities/Relative step", *step, 1e-8);
        check_at_most("Sensitivities/Relative step", *step, 0.1);
      }
    for (const unsigned int stage : stages)
      if (stage > n_stages)
        throw InputError("Sensitivities/Stages",
                         std::to_string(stage),
                         "there are only " + std::to_string(n_stages) +
                           " stages");
    for (unsigned int i = 0; i < outputs.size(); ++i)
      if (std::count(outputs.begin(), outputs.end(), outputs[i]) > 1)
        throw InputError("Sensitivities/Outputs",
                         outputs[i],
                         "an output must be listed only once");
    if (entries.empty() != outputs.empty())
      throw InputError("Sensitivities/Outputs",
                       outputs.empty() ? "" : outputs[0],
                       "there must be both 'Entries' and 'Outputs' or none");
  }


  bool
  SensitivityParameters::is_wanted(const unsigned int position,
                                   const unsigned int n_stages) const
  {
    return stages.empty()
             ? position + 1 == n_stages
             : std::count(stages.begin(), stages.end(), position + 1) > 0;
  }
} // namespace Biface
