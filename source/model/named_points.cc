// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <set>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/named_points.h>

namespace Biface
{
  using namespace dealii;

  void
  NamedPoints::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Named points",
                      list,
                      "Points of the surface that other entries refer to, and "
                      "whose displacements are written to probes.csv: a list "
                      "'name: alpha_1 alpha_2', separated by commas. Each must "
                      "be a node of the mesh. Unit: degrees for an angle, "
                      "length otherwise.",
                      Patterns::Anything());
  }


  std::vector<NamedPoint>
  NamedPoints::parse(const ReferenceSurface &surface) const
  {
    const std::string entry = "Named points";
    const std::string form  = "each point is written 'name: alpha_1 alpha_2'";

    check_list_length(entry, list, 10000);
    std::vector<NamedPoint> points;
    std::set<std::string>   names;
    for (const std::string &text : Utilities::split_string_list(list, ','))
      {
        const auto name_and_place = split_named(entry, text, form);
        if (name_and_place.second.empty())
          throw InputError(entry, text, form);
        const auto numbers =
          parse_numbers(entry, name_and_place.second, 2, form);
        if (!names.insert(name_and_place.first).second)
          throw InputError(entry, text, "each point must have its own name");

        points.push_back({name_and_place.first,
                          Point<2>(numbers[0] * surface.coordinate_unit(0),
                                   numbers[1] * surface.coordinate_unit(1))});
      }
    return points;
  }
} // namespace Biface
