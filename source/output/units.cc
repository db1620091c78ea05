// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cstdlib>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_text.h>
#include <biface/input/parameter_tools.h>
#include <biface/output/units.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    parse_units(const std::string &entry, const std::string &text)
    {
      std::vector<std::string> names;
      if (text.empty())
        return names;
      names      = split_list(entry, text);
      bool valid = (names.size() == 3);
      for (const std::string &name : names)
        valid = valid && !name.empty() && name.size() <= 12 &&
                name.find_first_of("<>&\"' \t") == std::string::npos;
      if (!valid)
        throw InputError(entry,
                         text,
                         "it must be empty or the names of the units of "
                         "length, force and time, as in 'mm, N, s'");
      return names;
    }


    /** Powers of force, length and time. */
    struct Dimension
    {
      int force, length, time;
    };

    constexpr Dimension length{0, 1, 0}, velocity{0, 1, -1}, force{1, 0, 0},
      tension{1, -1, 0}, stress{1, -2, 0}, power_per_volume{1, -2, -1};

    const std::map<std::string, Dimension> dimensions{
      {"displacement", length},
      {"contact_pressure", stress},
      {"friction", stress},
      {"slip_velocity", velocity},
      {"von_mises", stress},
      {"cord_tension", force},
      {"fiber_tension", tension},
      {"heat_source", power_per_volume}};

    /** As in "N/mm" and "mm/s"; a stress has names of its own. */
    std::string
    name_of(const Dimension &dimension, const std::vector<std::string> &names)
    {
      const std::string &length = names[0], &force = names[1], &time = names[2];
      if (dimension.force == 1 && dimension.length == -2 &&
          dimension.time == 0 && force == "N" &&
          (length == "mm" || length == "m"))
        return length == "mm" ? "MPa" : "Pa";
      std::string above, below;
      for (const auto &[unit, power] :
           {std::make_pair(force, dimension.force),
            std::make_pair(length, dimension.length),
            std::make_pair(time, dimension.time)})
        if (power != 0)
          {
            std::string &side = (power > 0 ? above : below);
            side += (side.empty() ? "" : " ") + unit +
                    (std::abs(power) > 1 ? "^" + std::to_string(std::abs(power))
                                         : std::string());
          }
      if (below.find(' ') != std::string::npos)
        below = "(" + below + ")";
      return above + (below.empty() ? "" : "/" + below);
    }


    /** Families of components. */
    const std::vector<std::pair<std::string, Dimension>> prefixes{
      {"H_", tension},
      {"s_", stress},
      {"t_", stress},
      {"interlaminar_t_", stress},
      {"cauchy_", stress}};
  } // namespace


  void
  Units::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(prm,
               "Units",
               "",
               names,
               parse_units,
               "The names of the units of length, force and time in this "
               "file, as in 'mm, N, s', for the report and for ParaView. No "
               "number depends on them. Empty: not named.",
               EntryKind::output);
  }


  std::map<std::string, std::string>
  Units::of_fields(const std::vector<std::string> &fields) const
  {
    std::map<std::string, std::string> result;
    if (names.empty())
      return result;
    for (const std::string &field : fields)
      {
        const auto found = dimensions.find(field);
        if (found != dimensions.end())
          result[field] = name_of(found->second, names);
        else
          for (const auto &[prefix, dimension] : prefixes)
            if (field.rfind(prefix, 0) == 0)
              result[field] = name_of(dimension, names);
      }
    return result;
  }
} // namespace Biface
