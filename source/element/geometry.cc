// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/element/geometry.h>

namespace Biface
{
  using namespace dealii;

  ElementGeometry
  compute_element_geometry(const FEValues<2, 3>   &at_vertices,
                           const FEValues<2, 3>   &at_center,
                           const ReferenceSurface &surface,
                           const std::array<std::array<double, 2>, 4> &faces)
  {
    ElementGeometry       geometry;
    std::array<double, 2> mean_faces{};
    for (unsigned int q = 0; q < 4; ++q)
      {
        const SurfacePoint point =
          surface.evaluate(surface.pull_back(at_vertices.quadrature_point(q)));
        ElementGeometry::Vertex &vertex = geometry.vertices[q];
        for (unsigned int a = 0; a < 2; ++a)
          {
            vertex.slope[a] = at_vertices.shape_grad(q, q) * point.frame[a];
            vertex.connection[a] = point.connection(a);

            Assert(std::abs(
                     at_vertices.shape_grad(q ^ (1 << a), q) * point.frame[a] +
                     vertex.slope[a]) <= 1e-8 * std::abs(vertex.slope[a]) &&
                     std::abs(at_vertices.shape_grad(q ^ (2 >> a), q) *
                              point.frame[a]) <=
                       1e-8 * std::abs(vertex.slope[a]),
                   ExcMessage("The sides of cells must be coordinate lines."));
          }
        vertex.metric    = ThicknessMetric(point.curvature, faces[q]);
        vertex.thickness = faces[q][1] - faces[q][0];
        for (unsigned int face = 0; face < 2; ++face)
          {
            for (unsigned int a = 0; a < 2; ++a)
              vertex.face_slope[face][a] =
                vertex.slope[a] * (faces[q][face] - faces[q ^ (1 << a)][face]);
            mean_faces[face] += faces[q][face] / 4;
          }
      }

    const SurfacePoint center =
      surface.evaluate(surface.pull_back(at_center.quadrature_point(0)));
    const ThicknessMetric metric(center.curvature, mean_faces);
    geometry.weight =
      at_center.JxW(0) * metric.zeta_bar[0] * metric.zeta_bar[1];
    return geometry;
  }
} // namespace Biface
