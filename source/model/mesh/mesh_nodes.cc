// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/mesh_nodes.h>
#include <biface/model/mesh/named_points.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  std::vector<double>
  Node::thickness_weights() const
  {
    // section 4 of doc/theory.md: what is spread over the thickness does work
    // on the mean of the layers, weighted by their thickness
    double thickness = 0;
    for (const double half : half_thickness)
      thickness += half;
    std::vector<double> result;
    double              below = 0;
    for (const double half : half_thickness)
      {
        result.push_back((thickness - 2 * below - half) / thickness);
        below += half;
      }
    return result;
  }


  MeshNodes::MeshNodes(const MPI_Comm                          communicator,
                       std::shared_ptr<const ReferenceSurface> surface,
                       const ChartGrid                        &grid,
                       const std::vector<NamedPoint>          &points)
    : communicator(communicator)
    , grid(grid)
    , points(points)
    , surface(std::move(surface))
  {}


  MeshNodes::MeshNodes(const MeshNodes &) = default;


  MeshNodes::~MeshNodes() = default;


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
    find_node(const NamedPoint &point, const MeshNodes &mesh)
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
      // as a length, since a difference of angles means nothing without the
      // radius
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


  namespace
  {
    /** The number of the node at a point of a surface without coordinates.
     * Throws InputError if there is none. */
    types::global_cell_index
    find_node(const NamedPoint            &point,
              const std::vector<Point<3>> &positions,
              const double                 size)
    {
      const auto nearest =
        std::min_element(positions.begin(),
                         positions.end(),
                         [&](const Point<3> &a, const Point<3> &b) {
                           return a.distance_square(*point.position) <
                                  b.distance_square(*point.position);
                         });
      const auto text = [](const Point<3> &x) {
        return number_to_string(x[0]) + " " + number_to_string(x[1]) + " " +
               number_to_string(x[2]);
      };
      if (!(nearest->distance(*point.position) <= 1e-6 * size))
        throw InputError("Named points",
                         point.name + ": " + text(*point.position),
                         "a point must be a node of the mesh; the nearest "
                         "node is at " +
                           text(*nearest));
      return nearest - positions.begin();
    }
  } // namespace


  void
  MeshNodes::find_points(const std::vector<Point<3>> &positions)
  {
    std::unordered_map<types::global_cell_index, unsigned int> by_number;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      by_number[nodes[n].number] = n;

    nodes_of_points.clear();
    for (NamedPoint &point : points)
      {
        types::global_cell_index number;
        if (point.position)
          {
            number         = find_node(point, positions, size());
            point.position = positions[number];
          }
        else
          {
            const GridIndex grid_index = find_node(point, *this);
            point.alpha                = grid.alpha(grid_index);
            number                     = grid.node_number(grid_index);
          }
        const auto node = by_number.find(number);
        // the node may be one of another rank
        nodes_of_points.push_back(node != by_number.end()
                                    ? node->second
                                    : numbers::invalid_unsigned_int);
      }
  }


  std::string
  MeshNodes::place_in_words(const Node &node) const
  {
    if (!surface->has_chart())
      return "(" + vector_to_string(node.surface.position) + ")";
    return "(" + number_to_string(node.alpha[0] / surface->coordinate_unit(0)) +
           ", " +
           number_to_string(node.alpha[1] / surface->coordinate_unit(1)) + ")";
  }


  void
  MeshNodes::require_direction(const std::string &entry,
                               const std::string &text) const
  {
    if (place_without_direction)
      throw InputError(entry,
                       text,
                       "the directions v_1 and v_2 have no meaning at (" +
                         vector_to_string(*place_without_direction) +
                         "), where 'Surface/Mesh/Direction' is normal to the "
                         "surface");
  }


  unsigned int
  MeshNodes::find_edge(const std::string &entry,
                       const std::string &text,
                       const std::string &name) const
  {
    std::string names;
    for (unsigned int i = 0; i < edges.size(); ++i)
      {
        if (edges[i].name == name)
          return i;
        names += (i == 0 ? "'" : ", '") + edges[i].name + "'";
      }
    throw InputError(
      entry,
      text,
      edges.empty() ? "the mesh has no group of lines, which would be an edge"
                    : "the edges are " + names);
  }


  unsigned int
  MeshNodes::node_of_point(const std::string &entry,
                           const std::string &name) const
  {
    return nodes_of_points[find_point(points, entry, name)];
  }
} // namespace Biface
