// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <biface/model/shell_mesh.h>

namespace Biface
{
  using namespace dealii;

  void
  ShellMesh::collect_cells_and_nodes(const ChartGrid &grid)
  {
    const FE_Q<2, 3> scalar_fe(1);
    FEValues<2, 3>   at_vertices(mapping,
                               scalar_fe,
                               QTrapezoid<2>(),
                               update_quadrature_points | update_gradients);
    FEValues<2, 3>   at_center(mapping,
                             scalar_fe,
                             QMidpoint<2>(),
                             update_quadrature_points | update_JxW_values);

    // from the vertices of the triangulation to nodes of this rank
    std::vector<unsigned int> node_of_vertex(triangulation->n_vertices(),
                                             numbers::invalid_unsigned_int);

    // where the second coordinate is periodic, that of a node is taken near
    // that of its cell, and within one turn from the begin of the grid
    const double period = surface->get_periodicity()[1];
    const double start  = grid.lines[1].front();
    const auto   center_of =
      [&](const DoFHandler<2, 3>::active_cell_iterator &cell) {
        Point<2> center = surface->pull_back(cell->center(true));
        if (period > 0)
          center[1] -= period * std::floor((center[1] - start) / period);
        return center;
      };
    const auto chart_point = [&](const Point<3> &vertex,
                                 const Point<2> &center) {
      Point<2> alpha = surface->pull_back(vertex);
      if (period > 0)
        {
          alpha[1] = center[1] + std::remainder(alpha[1] - center[1], period);
          if (grid.closed && alpha[1] > start + (1 - 1e-12) * period)
            alpha[1] -= period;
        }
      // the grid line itself, so that all ranks have the same numbers
      for (unsigned int a = 0; a < 2; ++a)
        {
          const auto &lines = grid.lines[a];
          const auto  above =
            std::lower_bound(lines.begin(), lines.end(), alpha[a]);
          if (above == lines.end() ||
              (above != lines.begin() &&
               alpha[a] - *(above - 1) < *above - alpha[a]))
            alpha[a] = *(above - 1);
          else
            alpha[a] = *above;
        }
      return alpha;
    };

    const auto line_of = [&](const double alpha, const unsigned int a = 0) {
      const auto &lines = grid.lines[a];
      return std::lower_bound(lines.begin(), lines.end(), alpha) -
             lines.begin();
    };
    const types::global_cell_index n_lines = grid.lines[0].size();

    const auto add_node =
      [&](const DoFHandler<2, 3>::active_cell_iterator &cell,
          const unsigned int                            v,
          const Point<2>                               &center) {
        unsigned int &index = node_of_vertex[cell->vertex_index(v)];
        if (index != numbers::invalid_unsigned_int)
          return index;

        Node node;
        node.alpha   = chart_point(cell->vertex(v), center);
        node.faces   = line_faces[line_of(node.alpha[0])];
        node.surface = surface->evaluate(node.alpha);
        node.number =
          line_of(node.alpha[0]) + n_lines * line_of(node.alpha[1], 1);
        for (unsigned int i = 0; i < 6; ++i)
          node.dofs[i] = cell->vertex_dof_index(v, i);
        node.locally_owned   = locally_owned.is_element(node.dofs[0]);
        node.outer_face_free = true;
        index                = nodes.size();
        nodes.push_back(node);
        return index;
      };

    std::vector<std::set<unsigned int>> adjacent;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;

        const Point<2>              center = center_of(cell);
        std::array<unsigned int, 4> cell_nodes;
        for (unsigned int v = 0; v < 4; ++v)
          cell_nodes[v] = add_node(cell, v, center);
        adjacent.resize(nodes.size());
        for (const unsigned int i : cell_nodes)
          adjacent[i].insert(cell_nodes.begin(), cell_nodes.end());

        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            {
              const std::array<unsigned int, 2> ends{
                {GeometryInfo<2>::face_to_cell_vertices(f, 0),
                 GeometryInfo<2>::face_to_cell_vertices(f, 1)}};
              const std::array<unsigned int, 2> side{
                {cell_nodes[ends[0]], cell_nodes[ends[1]]}};
              const unsigned int edge = cell->face(f)->boundary_id();
              edge_nodes[edge].insert(side.begin(), side.end());
              if (!cell->is_locally_owned())
                continue;

              // the coordinate that runs along the side
              const unsigned int a = 1 - f / 2;
              double d = nodes[side[1]].alpha[a] - nodes[side[0]].alpha[a];
              if (a == 1 && period > 0)
                d = std::remainder(d, period);
              const SurfacePoint middle = surface->evaluate(
                surface->pull_back(cell->face(f)->center(true)));
              boundary.push_back({static_cast<Edge>(edge),
                                  static_cast<unsigned int>(cells.size()),
                                  ends,
                                  side,
                                  std::abs(d) * middle.lame[a]});
            }

        if (!cell->is_locally_owned())
          continue;

        at_vertices.reinit(
          static_cast<Triangulation<2, 3>::cell_iterator>(cell));
        at_center.reinit(static_cast<Triangulation<2, 3>::cell_iterator>(cell));

        Cell local;
        local.nodes = cell_nodes;
        local.strip = line_of(nodes[cell_nodes[0]].alpha[0]);
        local.number =
          local.strip +
          (n_lines - 1) * line_of(nodes[cell_nodes[0]].alpha[1], 1);
        std::array<std::array<double, 2>, 4> faces;
        for (unsigned int v = 0; v < 4; ++v)
          {
            faces[v] = nodes[cell_nodes[v]].faces;
            for (unsigned int i = 0; i < 6; ++i)
              local.dofs[6 * v + i] = cell->vertex_dof_index(v, i);
          }
        local.geometry =
          compute_element_geometry(at_vertices, at_center, *surface, faces);
        cells.push_back(local);
      }

    for (const auto &set : adjacent)
      neighbors.emplace_back(set.begin(), set.end());
  }
} // namespace Biface
