// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>

#include <set>

#include <biface/model/shell_mesh.h>

namespace Biface
{
  using namespace dealii;

  void
  ShellMesh::collect_cells_and_nodes(const ChartGrid &grid)
  {
    ShellFEValues fe_values(*surface);

    // from the vertices of the triangulation to nodes of this rank
    std::vector<unsigned int> node_of_vertex(triangulation->n_vertices(),
                                             numbers::invalid_unsigned_int);

    const auto add_node =
      [&](const DoFHandler<2, 3>::active_cell_iterator &cell,
          const unsigned int                            v,
          const GridIndex                              &grid_index) {
        unsigned int &index = node_of_vertex[cell->vertex_index(v)];
        if (index != numbers::invalid_unsigned_int)
          return index;

        Node node;
        node.alpha        = grid.alpha(grid_index);
        node.face_heights = line_faces[grid_index[0]];
        node.surface      = surface->evaluate(node.alpha);
        node.number       = grid.node_number(grid_index);
        Assert(node.surface.position.distance(cell->vertex(v)) <
                 1e-8 * cell->diameter(),
               ExcMessage("Coarse cells must be numbered as in the grid."));
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

        const types::global_cell_index number = cell->id().get_coarse_cell_id();
        const GridIndex                cell_index = grid.cell_index(number);
        std::array<unsigned int, 4>    cell_nodes;
        for (unsigned int v = 0; v < 4; ++v)
          cell_nodes[v] = add_node(cell, v, grid.node_of_cell(cell_index, v));
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
              const unsigned int a     = 1 - f / 2;
              const double       begin = grid.lines[a][cell_index[a]],
                           end         = grid.lines[a][cell_index[a] + 1];
              Point<2> middle          = nodes[side[0]].alpha;
              middle[a]                = (begin + end) / 2;
              boundary.push_back(
                {static_cast<Edge>(edge),
                 static_cast<unsigned int>(cells.size()),
                 ends,
                 side,
                 (end - begin) * surface->evaluate(middle).lame[a]});
            }

        if (!cell->is_locally_owned())
          continue;

        Cell local;
        local.nodes  = cell_nodes;
        local.strip  = cell_index[0];
        local.number = number;
        ShellFEValues::FaceHeights face_heights;
        for (unsigned int v = 0; v < 4; ++v)
          {
            face_heights[v] = nodes[cell_nodes[v]].face_heights;
            for (unsigned int i = 0; i < 6; ++i)
              local.dofs[6 * v + i] = cell->vertex_dof_index(v, i);
          }
        fe_values.reinit(cell, face_heights);
        local.geometry = fe_values.get_geometry();
        cells.push_back(local);
      }

    for (const auto &set : adjacent)
      neighbors.emplace_back(set.begin(), set.end());
  }
} // namespace Biface
