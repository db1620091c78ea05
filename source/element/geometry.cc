// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/element/geometry.h>

namespace Biface
{
  using namespace dealii;

  ElementGeometry
  compute_element_geometry(const FEValues<2, 3>        &at_vertices,
                           const FEValues<2, 3>        &at_center,
                           const ReferenceSurface      &surface,
                           const std::array<double, 2> &faces)
  {
    ElementGeometry geometry;
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
        vertex.metric = ThicknessMetric(point.curvature, faces);
      }

    const SurfacePoint center =
      surface.evaluate(surface.pull_back(at_center.quadrature_point(0)));
    const ThicknessMetric metric(center.curvature, faces);
    geometry.weight =
      at_center.JxW(0) * metric.zeta_bar[0] * metric.zeta_bar[1];
    geometry.thickness = faces[1] - faces[0];
    return geometry;
  }
} // namespace Biface
