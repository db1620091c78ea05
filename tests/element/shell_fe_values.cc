// SPDX-License-Identifier: LGPL-2.1-or-later

// On a cell of a torus whose thickness grows along the meridian, the geometry
// of the paper's element is that of the formulas: frames, Lamé parameters,
// curvatures, slopes of the shape functions and of the faces at the vertices,
// area and mu-bar at the center.

#include <deal.II/base/numbers.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main()
{
  const double R = 50, r_c = 200, degree = numbers::PI / 180;

  // from 40 to 45 degrees along the meridian, from 10 to 15 around
  const auto heights = [&](const double s) {
    return std::array<double, 2>{{-2 - s, 1 + 3 * s}};
  };
  ChartGrid::Parameters parameters;
  parameters.intervals              = {{parse_intervals("intervals", "40:45:1"),
                                        parse_intervals("intervals", "10:15:1")}};
  parameters.closed                 = false;
  const SurfaceOfRevolution surface = torus();
  const double              step    = 5 * degree;
  Triangulation<2, 3>       triangulation;
  create_triangulation(surface, ChartGrid(parameters, surface), triangulation);

  ShellFEValues::FaceHeights face_heights;
  for (unsigned int v = 0; v < 4; ++v)
    face_heights[v] = heights(40 * degree + (v % 2) * step);
  ShellFEValues fe_values(surface, Formulation::paper);
  fe_values.reinit(triangulation.begin_active(), face_heights);
  const ElementGeometry &geometry = fe_values.get_geometry();

  double surface_error = 0, slope_error = 0, metric_error = 0, face_error = 0;
  for (unsigned int v = 0; v < 4; ++v)
    {
      const double s   = 40 * degree + (v % 2) * step;
      const double phi = 10 * degree + (v / 2) * step;
      const double r   = r_c + R * std::cos(s);
      const auto  &p   = fe_values.surface_at_vertex(v);

      const Tensor<1, 3> normal({std::cos(s) * std::cos(phi),
                                 std::sin(s),
                                 std::cos(s) * std::sin(phi)});
      surface_error =
        std::max({surface_error,
                  std::abs(p.lame[0] / R - 1),
                  std::abs(p.lame[1] / r - 1),
                  std::abs(p.curvature[0] * R - 1),
                  std::abs(p.curvature[1] * r / std::cos(s) - 1),
                  std::abs(p.geodesic[0] * r / std::sin(s) + 1),
                  std::abs(p.geodesic[1] * R),
                  (p.frame[2] - normal).norm(),
                  (cross_product_3d(p.frame[0], p.frame[1]) - normal).norm()});

      const auto                 &vertex = geometry.vertices[v];
      const std::array<double, 2> side{{R * step, r * step}};
      for (unsigned int a = 0; a < 2; ++a)
        {
          const double sign = ((v >> a) & 1 ? 1 : -1);
          slope_error =
            std::max(slope_error, std::abs(vertex.slope[a] * side[a] - sign));
        }

      const auto h = heights(s);
      metric_error = std::max(
        {metric_error,
         std::abs(vertex.thickness - h[1] + h[0]),
         std::abs(vertex.metric.zeta[0][0] - (1 + h[0] / R)),
         std::abs(vertex.metric.zeta[1][1] - (1 + h[1] * std::cos(s) / r))});
      face_error = std::max({face_error,
                             std::abs(vertex.face_slope[0][0] * R + 1),
                             std::abs(vertex.face_slope[1][0] * R - 3),
                             std::abs(vertex.face_slope[0][1]),
                             std::abs(vertex.face_slope[1][1])});
    }
  check_small("surface at the vertices", surface_error, 1e-13);
  check_small("slopes of shape functions", slope_error, 1e-12);
  check_small("distance of the faces", metric_error, 1e-13);
  check_small("slopes of the faces", face_error, 1e-12);

  const double s      = 42.5 * degree;
  const double r      = r_c + R * std::cos(s);
  const double mean   = (heights(s)[0] + heights(s)[1]) / 2;
  const double mu_bar = R * r * (1 + mean / R) * (1 + mean * std::cos(s) / r);
  check_small("frame at the center",
              fe_values.surface_at_center().frame[0][1] - std::cos(s),
              1e-13);
  check_small("area", fe_values.JxW() - R * r * step * step, 1e-12, R * r);
  check_small("weight", geometry.weight - mu_bar * step * step, 1e-12, mu_bar);
}
