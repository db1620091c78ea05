// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>
#include <biface/contact/suspension_parameters.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  namespace
  {
    NamedNumbers
    parse_suspensions(const std::string &entry, const std::string &text)
    {
      return parse_named_numbers(
        entry, text, "each item must have the form 'name: number'");
    }


    double
    value_of(const NamedNumbers &numbers, const std::string &name)
    {
      for (const auto &[other, value] : numbers)
        if (other == name)
          return value;
      return 0;
    }
  } // namespace


  void
  SuspensionParameters::add_parameters(EntryDeclarations &prm,
                                       const std::string &names)
  {
    const std::string list =
      "a comma-separated list of 'name: number' with " + names + ".";
    add_parsed(prm,
               "Springs",
               "",
               springs,
               parse_suspensions,
               "Springs against motions that 'Forces on bodies' of a stage "
               "find, without force at the factor 0: " +
                 list,
               Unit("force/length, for a motion that only turns force*length "
                    "per radian"));
    add_parsed(prm,
               "Dampers",
               "",
               dampers,
               parse_suspensions,
               "Forces against the velocity of motions that 'Forces on bodies' "
               "of a stage with 'Inertia' find, divided by it: " +
                 list,
               Unit("force*time/length, for a motion that only turns "
                    "force*length*time per radian"));
    add_parsed(prm,
               "Masses",
               "",
               masses,
               parse_suspensions,
               "Masses that motions carry which 'Forces on bodies' of a stage "
               "with 'Inertia' find: " +
                 list,
               Unit("mass, for a motion that only turns mass*length^2"));
  }


  void
  SuspensionParameters::check(
    const std::string                              &section,
    const std::function<bool(const std::string &)> &is_known,
    const std::string                              &known) const
  {
    for (const Item &item : items())
      {
        const std::string entry = section + "/" + item.entry;
        if (!is_known(item.name))
          throw InputError(entry, item.name, known);
        check_not_negative(entry, item.value);
      }
  }


  Suspension
  SuspensionParameters::of(const std::string &name) const
  {
    return {
      value_of(springs, name), value_of(dampers, name), value_of(masses, name)};
  }


  std::vector<SuspensionParameters::Item>
  SuspensionParameters::items() const
  {
    std::vector<Item> result;
    const auto        add = [&result](const std::string  &entry,
                               const NamedNumbers &numbers) {
      for (const auto &[name, value] : numbers)
        result.push_back({entry, name, value});
    };
    add("Springs", springs);
    add("Dampers", dampers);
    add("Masses", masses);
    return result;
  }
} // namespace Biface
