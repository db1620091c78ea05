// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <biface/model/contact/contact_pair.h>
#include <biface/model/quantities/penetration_between_points.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Call a function with the depth of the body between the points of a cell
     * with the nodes @p x, where it is in the shell. */
    template <typename Function>
    void
    add_depths_between_points(const Cell                    &cell,
                              const std::array<Point<3>, 4> &x,
                              const ContactPair             &pair,
                              const State                   &state,
                              const Loads                   &loads,
                              const Function                &function)
    {
      const ContactPoints &points = pair.points;
      const unsigned int   k      = points.per_side();
      std::vector<double>  clearances;
      for (unsigned int i = 0; i < points.per_cell(); ++i)
        clearances.push_back(
          pair.clearance(state, loads, points.number(cell, i)));
      // the parts of the points before and after a corner
      const auto parts = [&](const unsigned int corner) {
        const unsigned int before = std::clamp(corner, 1U, k - 1) - 1;
        const double       after  = corner - 0.5 - before;
        return std::pair(before, std::array<double, 2>{{1 - after, after}});
      };
      // at the corners of the parts, farthest from the points
      for (unsigned int j = 0; j <= k; ++j)
        for (unsigned int i = 0; i <= k; ++i)
          {
            const double   u = double(i) / k, v = double(j) / k;
            const Point<3> corner(
              (1 - v) *
                ((1 - u) * Tensor<1, 3>(x[0]) + u * Tensor<1, 3>(x[1])) +
              v * ((1 - u) * Tensor<1, 3>(x[2]) + u * Tensor<1, 3>(x[3])));
            const double in_shell = -pair.body(loads)->body.clearance(corner);
            if (in_shell <= 0)
              continue;
            const auto [first, along]   = parts(i);
            const auto [second, across] = parts(j);
            double at_points            = 0;
            for (unsigned int b = 0; b < 2; ++b)
              for (unsigned int a = 0; a < 2; ++a)
                at_points += along[a] * across[b] *
                             clearances[k * (second + b) + first + a];
            function(in_shell + at_points);
          }
    }

    /** Likewise between its nodes. */
    template <typename Function>
    void
    add_depths_between_nodes(const Cell                    &cell,
                             const std::array<Point<3>, 4> &x,
                             const ContactPair             &pair,
                             const State                   &state,
                             const Loads                   &loads,
                             const Function                &function)
    {
      // the sides of a cell, and both ways across its middle
      static const std::vector<std::vector<std::array<unsigned int, 2>>>
        between{{{{0, 1}}},
                {{{2, 3}}},
                {{{0, 2}}},
                {{{1, 3}}},
                {{{0, 1}}, {{2, 3}}, {{0, 2}}, {{1, 3}}}};

      const RigidBody            &now   = pair.body(loads)->body;
      const Resultants::Face      other = (pair.face == Resultants::outer)
                                            ? Resultants::inner
                                            : Resultants::outer;
      std::array<Tensor<1, 3>, 4> normal;
      std::array<double, 4>       clearances;
      for (unsigned int q = 0; q < 4; ++q)
        {
          normal[q] =
            x[q] - pair.mesh.deformed_position(
                     state.displacement, pair.mesh.nodes[cell.nodes[q]], other);
          normal[q] /= normal[q].norm();
          clearances[q] = now.clearance(x[q]);
        }
      for (const auto &sides : between)
        {
          // the mean of the ends, and what the face bulges between normals
          Tensor<1, 3> middle;
          double       at_nodes = 0;
          for (const auto &[i, j] : sides)
            {
              const double part  = 1. / sides.size();
              const double bulge = (x[j] - x[i]) * (normal[j] - normal[i]) / 8;
              middle += part * (x[i] + (x[j] - x[i]) / 2 - Point<3>());
              middle += part * std::min<std::size_t>(sides.size(), 2) * bulge *
                        (normal[i] + normal[j]) / 2;
              at_nodes += part * (clearances[i] + clearances[j]) / 2;
            }
          const double in_shell = -now.clearance(Point<3>(middle));
          if (in_shell > 0)
            function(in_shell + at_nodes);
        }
    }
  } // namespace


  PenetrationBetweenPoints
  penetration_between_points(const ContactPair &pair,
                             const State       &state,
                             const Loads       &loads)
  {
    PenetrationBetweenPoints deepest;
    if (!pair.body(loads) || pair.points.per_cell() == 1)
      return deepest;
    const ShellMesh &mesh = pair.mesh;
    for (const Cell &cell : mesh.wall_elements())
      {
        std::array<Point<3>, 4> x;
        double                  wall = std::numeric_limits<double>::infinity();
        for (unsigned int q = 0; q < 4; ++q)
          {
            const Node &node = mesh.nodes[cell.nodes[q]];
            x[q] = mesh.deformed_position(state.displacement, node, pair.face);
            wall = std::min(wall, node.face_heights[1] - node.face_heights[0]);
          }
        // the clearance bounds the distance
        const double size = std::max(x[0].distance(x[3]), x[1].distance(x[2]));
        if (pair.body(loads)->body.clearance(x[0]) > 2 * size)
          continue;
        const auto add = [&](const double depth) {
          deepest.depth    = std::max(deepest.depth, depth);
          deepest.relative = std::max(
            deepest.relative, depth / (wall + pair.tread.height.value_or(0)));
        };
        if (pair.points.at_nodes())
          add_depths_between_nodes(cell, x, pair, state, loads, add);
        else
          add_depths_between_points(cell, x, pair, state, loads, add);
      }
    deepest.depth    = Utilities::MPI::max(deepest.depth, mesh.communicator);
    deepest.relative = Utilities::MPI::max(deepest.relative, mesh.communicator);
    return deepest;
  }
} // namespace Biface
