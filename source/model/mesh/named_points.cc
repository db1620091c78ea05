// SPDX-License-Identifier: LGPL-2.1-or-later

#include <set>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/named_points.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  void
  NamedPoints::add_parameters(EntryDeclarations &prm)
  {
    add_parsed(prm,
               "Named points",
               "",
               list,
               parse_points,
               "Points of the surface to which other entries refer and whose "
               "displacements are written to probes.csv: a comma-separated "
               "list of 'name: alpha_1 alpha_2', or of 'name: x y z' where "
               "'Surface/Type = mesh', whose groups of single points are "
               "points with their names. Each must be a node of the "
               "mesh. The numbers may be formulas without blanks, such as "
               "360/7; that of alpha_1 may contain 'end', the largest alpha_1 "
               "of the surface.",
               Unit("degrees for an angle, length otherwise"));
  }


  std::vector<NamedPoint>
  parse_points(const std::string &entry, const std::string &text)
  {
    const std::string form = "each point must have the form 'name: alpha_1 "
                             "alpha_2' or, on a mesh from a file, 'name: x y "
                             "z'";

    std::vector<NamedPoint> points;
    std::set<std::string>   names;
    for (const std::string &item : split_list(entry, text))
      {
        const auto named = split_named(entry, item, form);
        if (named.second.empty())
          throw InputError(entry, item, form);
        if (!names.insert(named.first).second)
          throw InputError(entry, item, "the names of points must be unique");
        const auto words = split_words(named.second);
        NamedPoint point;
        point.name = named.first;
        if (words.size() == 3)
          {
            Point<3> x;
            for (unsigned int d = 0; d < 3; ++d)
              {
                const Coordinate coordinate(entry, words[d], item, form);
                if (coordinate.uses_end())
                  throw InputError(entry, named.second, form);
                x[d] = coordinate.value(0);
              }
            point.position = x;
            points.push_back(point);
            continue;
          }
        if (words.size() != 2)
          throw InputError(entry, named.second, form);
        const Coordinate alpha_1(entry, words[0], item, form);
        const Coordinate alpha_2(entry, words[1], item, form);
        if (alpha_2.uses_end())
          throw InputError(entry, named.second, form);
        point.alpha[1] = alpha_2.value(0);
        // where the surface ends is known only when it has been made
        if (alpha_1.uses_end())
          point.alpha_1 = alpha_1;
        else
          point.alpha[0] = alpha_1.value(0);
        points.push_back(point);
      }
    return points;
  }


  unsigned int
  find_point(const std::vector<NamedPoint> &points,
             const std::string             &entry,
             const std::string             &name)
  {
    std::string names;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        if (points[i].name == name)
          return i;
        names += (i == 0 ? "'" : ", '") + points[i].name + "'";
      }
    throw InputError(entry,
                     name,
                     points.empty()
                       ? "there are no points; list them in 'Named points'"
                       : "the points are " + names);
  }


  std::vector<NamedPoint>
  NamedPoints::on(const ReferenceSurface &surface) const
  {
    std::vector<NamedPoint> points = list;
    for (NamedPoint &point : points)
      {
        if (point.position.has_value() == surface.has_chart())
          throw InputError("Named points",
                           point.name,
                           surface.has_chart()
                             ? "it must have two coordinates, alpha_1 and "
                               "alpha_2, on this surface"
                             : "it must have three coordinates, x, y and z, on "
                               "a mesh from a file");
        if (point.position)
          continue;
        if (point.alpha_1)
          point.alpha[0] = point.alpha_1->value(surface.end(0));
        for (unsigned int a = 0; a < 2; ++a)
          point.alpha[a] *= surface.coordinate_unit(a);
      }
    return points;
  }
} // namespace Biface
