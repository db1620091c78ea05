// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <biface/base/gather.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_summary.h>
#include <biface/model/quantities/footprint.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** A node of the face. */
    struct FaceNode
    {
      Point<3> x;
      /** Not negative. */
      double clearance;
      double pressure;
      bool   active;
    };


    /** The nodes of all ranks by number, on the first rank. */
    std::vector<FaceNode>
    gather_nodes(const ContactPair  &pair,
                 const State        &state,
                 const PlacedBody   &placed,
                 const ContactState &zone)
    {
      const ShellMesh &mesh = pair.mesh;
      // on the first rank, since lines of the mesh cross all ranks
      constexpr unsigned int n_columns = 7;
      std::vector<double>    values;
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].locally_owned)
          {
            const Node    &node = mesh.nodes[n];
            const Point<3> x =
              mesh.deformed_position(state.displacement, node, pair.face);
            const double clearance = placed.body.clearance(x);
            values.insert(
              values.end(),
              {static_cast<double>(node.number),
               x[0],
               x[1],
               x[2],
               std::max(0., clearance),
               zone.pressure(n),
               // a node around a point may be clear of the body
               zone.active[n] && (pair.points.at_nodes() || clearance < 0)
                 ? 1.
                 : 0.});
          }
      values = gather_numbers(mesh.communicator, values);

      std::vector<FaceNode> nodes(values.size() / n_columns);
      for (auto value = values.begin(); value != values.end();
           value += n_columns)
        nodes[static_cast<std::size_t>(value[0])] = {
          Point<3>(value[1], value[2], value[3]),
          value[4],
          value[5],
          value[6] > 0};
      return nodes;
    }


    /** See Footprint::max_pressure; on the first rank. */
    double
    max_recovered_pressure(const ContactPair  &pair,
                           const ContactState &zone,
                           const std::size_t   n_nodes)
    {
      const ShellMesh       &mesh      = pair.mesh;
      constexpr unsigned int n_columns = 4;
      // the value at a vertex of the dual functions of the vertices, in one
      // dimension
      const bool lumped =
        (pair.points.at_nodes() && pair.mortar_matrix == MortarMatrix::lumped);
      const double same = (lumped ? 2 : 1), other = (lumped ? -1 : 0);

      std::vector<double> values;
      for (const Cell &cell : mesh.wall_elements())
        {
          const auto n_active =
            std::count_if(cell.nodes.begin(),
                          cell.nodes.end(),
                          [&](const unsigned int n) { return zone.active[n]; });
          if (n_active == 0)
            continue;
          const double is_full = (n_active == 4 ? 1. : 0.);
          for (unsigned int r = 0; r < 4; ++r)
            {
              double pressure = 0;
              for (unsigned int s = 0; s < 4; ++s)
                pressure += ((r ^ s) & 1 ? other : same) *
                            ((r ^ s) & 2 ? other : same) *
                            zone.pressure(cell.nodes[s]);
              values.insert(
                values.end(),
                {static_cast<double>(mesh.nodes[cell.nodes[r]].number),
                 is_full,
                 cell.geometry.weight,
                 cell.geometry.weight * pressure});
            }
        }
      values = gather_numbers(mesh.communicator, values);

      // numbers of cells and of those in contact, area, and the integral of the
      // pressure
      std::vector<std::array<double, n_columns>> sums(n_nodes);
      for (auto value = values.begin(); value != values.end();
           value += n_columns)
        {
          auto &sum = sums[static_cast<std::size_t>(value[0])];
          sum[0] += 1;
          for (unsigned int i = 1; i < n_columns; ++i)
            sum[i] += value[i];
        }
      double maximum = 0;
      for (const auto &sum : sums)
        if (sum[0] > 0 && sum[1] == sum[0])
          maximum = std::max(maximum, sum[3] / sum[2]);
      return maximum;
    }


    /** The nodes in their grid. */
    class NodeGrid
    {
    public:
      NodeGrid(const ChartGrid &grid, const std::vector<FaceNode> &nodes)
        : grid(grid), nodes(nodes)
      {}

      /** The node some lines further along the coordinate @p a, or null beyond
       * the shell. */
      const FaceNode *
      neighbor(const GridIndex &of, const unsigned int a, const int lines) const
      {
        const int n      = grid.n_nodes(a);
        int       i      = static_cast<int>(of[a]) + lines;
        GridIndex result = of;
        if (a == 1 && grid.closed)
          i = (i % n + n) % n;
        if (i < 0 || i >= n)
          return nullptr;
        result[a] = i;
        return &nodes[grid.node_number(result)];
      }

      /** The end of the part of a line that a node in contact covers.
       * @param side -1 or 1 */
      Point<3>
      end_of_part(const GridIndex   &node,
                  const unsigned int a,
                  const int          side) const
      {
        const FaceNode &at     = *neighbor(node, a, 0);
        const FaceNode *before = neighbor(node, a, -side);
        const FaceNode *next   = neighbor(node, a, side);
        const FaceNode *beyond = neighbor(node, a, 2 * side);
        if (!next)
          return at.x;
        const Point<3> end = halfway(at.x, next->x);
        // no clearances beyond, or a single node between nodes in contact
        if (next->active || !beyond || beyond->active)
          return end;

        // P/(P + G) of section 6 of doc/theory.md, "The footprint", with the
        // ratio as the factor of g_1/g_2 in G
        const double h_1 = at.x.distance(next->x),
                     h_2 = next->x.distance(beyond->x),
                     h_0 = (before ? at.x.distance(before->x) : h_1);
        const double ratio =
          1 + h_2 * (h_0 + 2 * h_1 + h_2) / (h_1 * (h_0 + h_1));
        const double clearance =
          next->clearance > 0 ? ratio * next->clearance /
                                  std::max(next->clearance, beyond->clearance)
                              : 0;
        // a single node covers nothing at first, when the clearance is
        // quadratic
        double pressure = ratio * h_0 * h_1 / ((h_1 + h_2) * (h_1 + h_2));
        if (before && before->pressure > 0)
          pressure = at.pressure / before->pressure;
        const double sum      = pressure + clearance;
        const double fraction = (sum > 0 ? pressure / sum : 0.5);

        const Point<3> begin = (before ? halfway(at.x, before->x) : at.x);
        return begin + fraction * (end - begin);
      }

    private:
      static Point<3>
      halfway(const Point<3> &x, const Point<3> &y)
      {
        return x + (y - x) / 2;
      }

      const ChartGrid             &grid;
      const std::vector<FaceNode> &nodes;
    };


    /** The minimum and the maximum of the numbers added. */
    struct Range
    {
      double least   = std::numeric_limits<double>::infinity();
      double largest = -std::numeric_limits<double>::infinity();

      void
      add(const double value)
      {
        least   = std::min(least, value);
        largest = std::max(largest, value);
      }

      double
      extent() const
      {
        return std::max(0., largest - least);
      }
    };


    /** The directions along and across the zone: across is the projection of
     * the y axis, of the z axis if the ground travels along y. */
    std::array<Tensor<1, 3>, 2>
    directions_of_zone(const Tensor<1, 3> &direction)
    {
      Tensor<1, 3> across = Tensor<1, 3>({0, 1, 0}) - direction[1] * direction;
      if (across.norm() < 1e-6)
        across = Tensor<1, 3>({0, 0, 1}) - direction[2] * direction;
      across /= across.norm();
      return {{cross_product_3d(across, direction), across}};
    }


    /** Length, width and area, on the first rank. */
    Footprint
    measure(const ChartGrid             &grid,
            const std::vector<FaceNode> &nodes,
            const Tensor<1, 3>          &direction)
    {
      const auto [along, across] = directions_of_zone(direction);

      const NodeGrid node_grid(grid, nodes);
      Footprint      result;
      Range          length, width;
      GridIndex      index;
      for (index[1] = 0; index[1] < grid.n_nodes(1); ++index[1])
        for (index[0] = 0; index[0] < grid.n_nodes(0); ++index[0])
          {
            if (!node_grid.neighbor(index, 0, 0)->active)
              continue;
            std::array<Tensor<1, 3>, 2> parts;
            for (unsigned int a = 0; a < 2; ++a)
              {
                const FaceNode    *before = node_grid.neighbor(index, a, -1);
                const FaceNode    *next   = node_grid.neighbor(index, a, 1);
                const FaceNode    *at     = node_grid.neighbor(index, a, 0);
                const Tensor<1, 3> line =
                  (next ? next : at)->x - (before ? before : at)->x;
                std::array<Point<3>, 2> ends{
                  {node_grid.end_of_part(index, a, -1),
                   node_grid.end_of_part(index, a, 1)}};
                // ends that have passed each other leave nothing between them
                if ((ends[1] - ends[0]) * line < 0)
                  ends[0] = ends[1] = ends[0] + (ends[1] - ends[0]) / 2;
                parts[a] = ends[1] - ends[0];

                // lines across say nothing about the extent along; lines at
                // less than 60 degrees to both directions count for both
                const double least = 0.5 * line.norm();
                for (const Point<3> &end : ends)
                  {
                    if (std::abs(line * along) >= least)
                      length.add(end * along);
                    if (std::abs(line * across) >= least)
                      width.add(end * across);
                  }
              }
            result.area += cross_product_3d(parts[0], parts[1]).norm();
          }
      result.length = length.extent();
      result.width  = width.extent();
      return result;
    }


    /** The parts of a cell that its points of contact cover, by their corners
     * in the unit cell: the nodes up to halfway to their neighbors, other
     * points equal parts. */
    std::vector<std::array<Point<2>, 2>>
    parts_of_cell(const ContactPoints &points)
    {
      const unsigned int k = (points.at_nodes() ? 2 : points.per_side());
      std::vector<std::array<Point<2>, 2>> parts;
      for (unsigned int j = 0; j < k; ++j)
        for (unsigned int i = 0; i < k; ++i)
          parts.push_back({{Point<2>(i, j) / k, Point<2>(i + 1, j + 1) / k}});
      return parts;
    }


    /** The same on a mesh without lines, on all ranks: each point of contact
     * covers its part of the cell. */
    Footprint
    measure_by_cells(const ContactPair &pair,
                     const State       &state,
                     const PlacedBody  &placed)
    {
      const ShellMesh &mesh       = pair.mesh;
      const ActiveSet &active     = pair.state_of(state).active;
      const auto       directions = directions_of_zone(placed.body.direction());
      const auto       parts      = parts_of_cell(pair.points);
      Footprint        result;
      std::array<Range, 2> extents;
      for (const Cell &cell : mesh.wall_elements())
        {
          std::array<Point<3>, 4> x;
          for (unsigned int v = 0; v < 4; ++v)
            x[v] = mesh.deformed_position(
              state.displacement, mesh.nodes[cell.nodes[v]], pair.face);
          for (unsigned int i = 0; i < parts.size(); ++i)
            {
              if (!active[pair.points.number(cell, i)])
                continue;
              std::array<Point<3>, 4> corners;
              for (unsigned int c = 0; c < 4; ++c)
                {
                  const Point<2> xi(parts[i][c & 1][0], parts[i][c >> 1][1]);
                  for (unsigned int v = 0; v < 4; ++v)
                    corners[c] +=
                      GeometryInfo<2>::d_linear_shape_function(xi, v) * x[v];
                  for (unsigned int d = 0; d < 2; ++d)
                    extents[d].add(corners[c] * directions[d]);
                }
              // by its diagonals
              result.area += cross_product_3d(corners[3] - corners[0],
                                              corners[2] - corners[1])
                               .norm() /
                             2;
            }
        }
      const MPI_Comm communicator = mesh.communicator;
      result.area = Utilities::MPI::sum(result.area, communicator);
      for (Range &range : extents)
        {
          range.least   = Utilities::MPI::min(range.least, communicator);
          range.largest = Utilities::MPI::max(range.largest, communicator);
        }
      result.length = extents[0].extent();
      result.width  = extents[1].extent();
      return result;
    }
  } // namespace


  Footprint
  find_footprint(const ContactPair &pair,
                 const State       &state,
                 const Loads       &loads)
  {
    Footprint result;
    if (!pair.body(loads) || count_active(pair, state) == 0)
      return result;

    const ShellMesh   &mesh   = pair.mesh;
    const PlacedBody  &placed = *pair.body(loads);
    const ContactState zone =
      contact_at_nodes(mesh, state, pair.number, placed);
    if (!mesh.grid.has_lines())
      result = measure_by_cells(pair, state, placed);
    const auto   nodes = gather_nodes(pair, state, placed, zone);
    const double max_pressure =
      max_recovered_pressure(pair, zone, nodes.size());
    if (Utilities::MPI::this_mpi_process(mesh.communicator) == 0)
      {
        if (mesh.grid.has_lines())
          result = measure(mesh.grid, nodes, placed.body.direction());
        result.max_pressure = max_pressure;
        // no node has all its neighbors in contact
        if (max_pressure == 0)
          for (const FaceNode &node : nodes)
            result.max_pressure = std::max(result.max_pressure, node.pressure);
      }
    const auto values = Utilities::MPI::broadcast(
      mesh.communicator,
      std::array<double, 4>{
        {result.length, result.width, result.area, result.max_pressure}});
    return {values[0], values[1], values[2], values[3]};
  }
} // namespace Biface
