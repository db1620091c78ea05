// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  using namespace dealii;

  void
  NamedPoints::add_parameters(ParameterHandler &prm)
  {
    add_parsed(prm,
               "",
               "Named points",
               "",
               list,
               parse_points,
               "Points of the surface to which other entries refer and whose "
               "displacements are written to probes.csv: a comma-separated "
               "list of 'name: alpha_1 alpha_2'. Each must be a node of the "
               "mesh. Both may be formulas without blanks, such as 360/7; that "
               "of alpha_1 may contain 'end', the largest alpha_1 of the "
               "surface. Unit: degrees for an angle, "
               "length otherwise.");
  }


  std::vector<NamedPoint>
  parse_points(const std::string &entry, const std::string &text)
  {
    const std::string form = "each point must have the form 'name: alpha_1 "
                             "alpha_2'";

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
        if (words.size() != 2)
          throw InputError(entry, named.second, form);
        const Coordinate alpha_1(entry, words[0], item, form);
        const Coordinate alpha_2(entry, words[1], item, form);
        if (alpha_2.uses_end())
          throw InputError(entry, named.second, form);
        NamedPoint point;
        point.name     = named.first;
        point.alpha[1] = alpha_2.value(0);
        if (alpha_1.uses_end())
          point.alpha_1 = alpha_1;
        else
          point.alpha[0] = alpha_1.value(0);
        points.push_back(point);
      }
    return points;
  }


  namespace
  {
    [[noreturn]] void
    throw_no_such_point(const std::string             &entry,
                        const std::string             &name,
                        const std::vector<NamedPoint> &points)
    {
      std::string names;
      for (const NamedPoint &point : points)
        names += (names.empty() ? "'" : ", '") + point.name + "'";
      throw InputError(entry,
                       name,
                       points.empty()
                         ? "there are no points; list them in 'Named points'"
                         : "the points are " + names);
    }
  } // namespace


  void
  NamedPoints::check_name(const std::string &entry,
                          const std::string &name) const
  {
    if (std::none_of(list.begin(), list.end(), [&](const NamedPoint &point) {
          return point.name == name;
        }))
      throw_no_such_point(entry, name, list);
  }


  std::vector<NamedPoint>
  NamedPoints::on(const ReferenceSurface &surface) const
  {
    std::vector<NamedPoint> points = list;
    for (NamedPoint &point : points)
      {
        if (point.alpha_1)
          point.alpha[0] = point.alpha_1->value(surface.end(0));
        for (unsigned int a = 0; a < 2; ++a)
          point.alpha[a] *= surface.coordinate_unit(a);
      }
    return points;
  }


  namespace
  {
    unsigned int
    nearest_line(const std::vector<double> &lines, const double alpha)
    {
      const auto above =
        std::lower_bound(lines.begin() + 1, lines.end() - 1, alpha);
      const bool below = alpha - above[-1] < above[0] - alpha;
      return above - lines.begin() - (below ? 1 : 0);
    }


    /** The node at a point. Throws InputError if there is none. */
    GridIndex
    find_node(const NamedPoint &point, const ShellMesh &mesh)
    {
      const ReferenceSurface &surface = mesh.get_surface();
      const auto             &lines   = mesh.grid.lines;

      // in a periodic coordinate, a point outside the grid may mean one inside
      Point<2>     alpha  = point.alpha;
      const double period = surface.get_periodicity()[1];
      const double start = lines[1].front(), end = lines[1].back();
      if (period > 0 &&
          (alpha[1] < start - 1e-9 * period || alpha[1] > end + 1e-9 * period))
        alpha[1] = (start + end) / 2 +
                   std::remainder(alpha[1] - (start + end) / 2, period);

      GridIndex node;
      Point<2>  nearest;
      for (unsigned int a = 0; a < 2; ++a)
        {
          node[a]    = nearest_line(lines[a], alpha[a]);
          nearest[a] = lines[a][node[a]];
        }
      const SurfacePoint at_node = surface.evaluate(nearest);
      for (unsigned int a = 0; a < 2; ++a)
        if (!(std::abs(alpha[a] - nearest[a]) * at_node.lame[a] <
              1e-8 * mesh.size()))
          {
            const auto text = [&](const Point<2> &place) {
              std::string numbers;
              for (unsigned int b = 0; b < 2; ++b)
                {
                  const double unit = surface.coordinate_unit(b);
                  numbers +=
                    (b == 0 ? "" : " ") + number_to_string(place[b] / unit);
                }
              return numbers;
            };
            throw InputError("Named points",
                             point.name + ": " + text(point.alpha),
                             "a point must be a node of the mesh; the nearest "
                             "node is at " +
                               text(nearest));
          }
      node[1] %= mesh.grid.n_nodes(1);
      return node;
    }
  } // namespace


  std::vector<unsigned int>
  find_nodes(std::vector<NamedPoint> &points, const ShellMesh &mesh)
  {
    if (points.empty())
      return {};

    std::unordered_map<types::global_cell_index, unsigned int> by_number;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      by_number[mesh.nodes[n].number] = n;

    std::vector<unsigned int> nodes;
    for (NamedPoint &point : points)
      {
        const GridIndex grid_index = find_node(point, mesh);
        point.alpha                = mesh.grid.alpha(grid_index);
        const auto node = by_number.find(mesh.grid.node_number(grid_index));
        nodes.push_back(node != by_number.end()
                          ? node->second
                          : numbers::invalid_unsigned_int);
      }
    return nodes;
  }


  unsigned int
  node_of_point(const ShellMesh   &mesh,
                const std::string &entry,
                const std::string &name)
  {
    for (unsigned int i = 0; i < mesh.points.size(); ++i)
      if (mesh.points[i].name == name)
        return mesh.nodes_of_points[i];

    throw_no_such_point(entry, name, mesh.points);
  }


  LA::Vector
  displacement_functional(const ShellMesh   &mesh,
                          const std::string &point,
                          const Component    component)
  {
    LA::Vector         functional = mesh.owned_vector();
    const unsigned int n          = node_of_point(mesh, "Control point", point);
    if (n != numbers::invalid_unsigned_int && mesh.nodes[n].locally_owned)
      {
        const Node        &node = mesh.nodes[n];
        const Tensor<1, 3> unit =
          direction(component, node.surface, mesh.get_surface().axis());
        for (unsigned int i = 0; i < 3; ++i)
          functional(node.dof(i, MixedElement::mean)) = unit[i];
      }
    functional.compress(VectorOperation::insert);
    return functional;
  }
} // namespace Biface
