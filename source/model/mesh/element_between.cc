// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/quadrilateral_geometry.h>
#include <biface/model/mesh/element_between.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  using namespace dealii;

  Cell
  element_between(const ShellMesh                   &mesh,
                  const std::array<unsigned int, 4> &nodes)
  {
    Cell                element{};
    QuadrilateralPoints points;
    element.nodes   = nodes;
    element.is_wall = true;
    for (unsigned int v = 0; v < 4; ++v)
      {
        const Node &node = mesh.nodes[nodes[v]];
        element.dofs.insert(
          element.dofs.end(), node.dofs.begin(), node.dofs.end());
        element.positions.insert(
          element.positions.end(), node.entries.begin(), node.entries.end());
        points.vertices[v] = node.surface;
        points.heights[v]  = node.face_heights;

        ElementGeometry::Vertex &vertex = element.geometry.vertices[v];
        vertex.thickness = node.face_heights[1] - node.face_heights[0];
        vertex.axes      = in_columns(node.surface);
      }
    element.geometry.along_lines = false;
    element.geometry.stations    = straight_stations(points);
    // the faces move by the half differences over all layers
    element.contributions.resize(4 * mesh.n_layers());
    return element;
  }
} // namespace Biface
