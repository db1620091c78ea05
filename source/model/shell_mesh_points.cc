// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>
#include <string>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/shell_mesh.h>

namespace Biface
{
  using namespace dealii;

  void
  ShellMesh::find_points()
  {
    for (const NamedPoint &point : points)
      {
        unsigned int   found    = numbers::invalid_unsigned_int;
        double         distance = std::numeric_limits<double>::max();
        const Point<3> position = surface->evaluate(point.alpha).position;
        for (unsigned int n = 0; n < nodes.size(); ++n)
          {
            const double d = nodes[n].alpha.distance(point.alpha);
            if (nodes[n].surface.position.distance(position) <
                  1e-8 * diameter &&
                d < distance)
              {
                found    = n;
                distance = d;
              }
          }
        // both lips of a slit are at one place: the nearer coordinate counts
        const double nearest = Utilities::MPI::min(distance, communicator);
        if (nearest == std::numeric_limits<double>::max())
          throw InputError(
            "Named points",
            point.name + ": " +
              number_to_string(point.alpha[0] / surface->coordinate_unit(0)) +
              " " +
              number_to_string(point.alpha[1] / surface->coordinate_unit(1)),
            "a point must be a node of the mesh");
        nodes_of_points.push_back(
          distance <= nearest + 1e-9 ? found : numbers::invalid_unsigned_int);
      }
  }


  unsigned int
  ShellMesh::node_of_point(const std::string &entry,
                           const std::string &name) const
  {
    std::string names;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        if (points[i].name == name)
          return nodes_of_points[i];
        names += (names.empty() ? "'" : ", '") + points[i].name + "'";
      }
    throw InputError(entry,
                     name,
                     points.empty()
                       ? "there are no points; they are named in 'Named points'"
                       : "the points are " + names);
  }


  LA::Vector
  ShellMesh::displacement_functional(const std::string &point,
                                     const unsigned int component) const
  {
    LA::Vector         functional = owned_vector();
    const unsigned int n          = node_of_point("Control point", point);
    if (n != numbers::invalid_unsigned_int && nodes[n].locally_owned)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int face = 0; face < 2; ++face)
          functional(nodes[n].dofs[2 * i + face]) =
            nodes[n].surface.frame[i][component] / 2;
    functional.compress(VectorOperation::insert);
    return functional;
  }
} // namespace Biface
