// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/controls/resultant_control.h>

namespace Biface
{
  using namespace dealii;

  ResultantControl::ResultantControl(const Stage                &stage,
                                     const Parameters           &parameters,
                                     const ControlledResultants &resultants)
    : EqualSteps(stage, parameters)
    , resultants(resultants)
    , start_values(resultants.size())
  {}


  void
  ResultantControl::check(const std::string &section,
                          const KnownStart  &start) const
  {
    for (const auto &resultant : resultants)
      resultant->check(stage, section, start);
  }


  void
  ResultantControl::check(const std::string &section,
                          const ShellMesh   &mesh) const
  {
    Biface::check(resultants, section, mesh);
  }


  Control::KnownStart
  ResultantControl::known_end(const KnownStart &start) const
  {
    return without_found_loads(resultants, EqualSteps::known_end(start));
  }


  void
  ResultantControl::begin(const Equilibrium &from)
  {
    EqualSteps::begin(from);
    // without pressure no moment depends on the angular velocity
    const bool needs_contact =
      resultants.size() > 1 &&
      std::any_of(resultants.begin(), resultants.end(), [](const auto &item) {
        return item->needs_contact();
      });
    if (needs_contact && count_active(from.contact.ground(), from.state) == 0)
      throw InputError("the stage '" + stage.name +
                       "' has 'Control = " + stage.control_name() +
                       "' and must start in contact, such as after a stage "
                       "with 'Control = foundation force'.");
    // the path starts from what ground and bodies exert here, so that the first
    // step is no larger than the others
    const Loads loads = from.loads(from.level);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      start_values[i] =
        resultants[i]
          ->evaluate({from.equations, from.contact, from.state, loads}, {})
          .value;
  }


  Control::Trial
  ResultantControl::propose(const Equilibrium &from) const
  {
    const double    part = next();
    const LoadLevel end  = level_at(part);
    Trial           trial;
    // all other loads follow the fraction of the stage
    trial.level = [this, end](const LoadParameters &mu) {
      return with_found_loads(resultants, end, mu);
    };
    trial.mu.clear();
    for (const auto &resultant : resultants)
      trial.mu.push_back(resultant->guess(from, end));
    trial.equations =
      std::make_shared<const ResultantEquations>(resultants, values_at(part));
    trial.size = part - fraction;
    return trial;
  }


  std::vector<double>
  ResultantControl::values_at(const double fraction) const
  {
    std::vector<double> values(start_values);
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] += fraction * (resultants[i]->end(stage) - start_values[i]);
    return values;
  }


  Control::Memory
  ResultantControl::get_memory() const
  {
    Memory memory = EqualSteps::get_memory();
    for (unsigned int i = 0; i < resultants.size(); ++i)
      memory.numbers["start " + resultants[i]->name()] = start_values[i];
    return memory;
  }


  void
  ResultantControl::restore(const Memory &memory)
  {
    EqualSteps::restore(memory);
    for (unsigned int i = 0; i < resultants.size(); ++i)
      start_values[i] = memory.numbers.at("start " + resultants[i]->name());
  }


  void
  ResultantControl::change_path(const Stage &now, const LoadLevel &reached)
  {
    const std::vector<double> values = values_at(fraction);
    // the unknown loads follow no path
    const LoadParameters     at_start     = found_loads(resultants, start);
    std::vector<Progression> progressions = progressions_of_loads(
      with_found_loads(resultants, reached, at_start),
      with_found_loads(resultants, now.end(start), at_start));
    for (unsigned int i = 0; i < resultants.size(); ++i)
      progressions.push_back(
        {start_values[i], values[i], resultants[i]->end(now)});
    // loads and resultants that are on no common part of the new path are its
    // start
    if (!go_on_from(common_part(progressions), reached))
      start_values = values;
  }
} // namespace Biface
