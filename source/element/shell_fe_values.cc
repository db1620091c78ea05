// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

#include <biface/element/quadrilateral.h>
#include <biface/element/quadrilateral_geometry.h>
#include <biface/element/shell_fe_values.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  ShellFEValues::ShellFEValues(const ReferenceSurface &surface,
                               const Formulation       formulation,
                               const bool              normal_thickness)
    : surface(surface)
    , fe(1)
    , at_vertices(mapping,
                  fe,
                  QTrapezoid<2>(),
                  update_quadrature_points | update_gradients)
    , at_center(mapping,
                fe,
                QMidpoint<2>(),
                update_quadrature_points | update_JxW_values)
  {
    Assert(formulation != Formulation::paper || !normal_thickness,
           ExcNotImplemented());
    geometry.formulation      = formulation;
    geometry.normal_thickness = normal_thickness;
  }


  void
  ShellFEValues::reinit(const Triangulation<2, 3>::cell_iterator &cell,
                        const FaceHeights                        &face_heights,
                        const double wall_thickness)
  {
    at_vertices.reinit(cell);
    at_center.reinit(cell);

    std::array<double, 2> heights_at_center{};
    for (unsigned int q = 0; q < 4; ++q)
      {
        points[q] =
          surface.evaluate(surface.pull_back(at_vertices.quadrature_point(q)));
        const SurfacePoint      &point   = points[q];
        const auto              &heights = face_heights[q];
        ElementGeometry::Vertex &vertex  = geometry.vertices[q];
        for (unsigned int a = 0; a < 2; ++a)
          {
            // along coordinate lines, only the vertex and its neighbor have
            // slopes
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
        vertex.metric    = ThicknessMetric(point.curvature, heights);
        vertex.thickness = heights[1] - heights[0];
        for (unsigned int face = 0; face < 2; ++face)
          {
            for (unsigned int a = 0; a < 2; ++a)
              vertex.face_slope[face][a] =
                vertex.slope[a] *
                (heights[face] - face_heights[q ^ (1 << a)][face]);
            heights_at_center[face] += heights[face] / 4;
          }
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            vertex.axes[i][j] = point.frame[j][i];
      }

    set_stations(face_heights);

    center = surface.evaluate(surface.pull_back(at_center.quadrature_point(0)));
    if (geometry.formulation != Formulation::paper)
      {
        interpolate_positions(face_heights, wall_thickness);
        return;
      }

    const ThicknessMetric metric(center.curvature, heights_at_center);
    geometry.weight = JxW() * metric.zeta_bar[0] * metric.zeta_bar[1];
    geometry.vertex_areas.fill(geometry.weight / 4);
  }


  void
  ShellFEValues::set_stations(const FaceHeights &face_heights)
  {
    if (geometry.formulation != Formulation::paper)
      {
        geometry.stations = straight_stations({points, face_heights, {}, 0});
        return;
      }
    ElementGeometry::Stations &stations = geometry.stations;
    const Tensor<1, 3>         axis     = surface.axis();
    // a frame that turns needs the distance from its axis
    stations.origin = axis.norm_square() > 0
                        ? Tensor<1, 3>((points[0].position * axis) * axis)
                        : Tensor<1, 3>(points[0].position);

    for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int left = 2 * side, right = left + 1;
        const Point<2> alpha_left  = surface.pull_back(points[left].position),
                       alpha_right = surface.pull_back(points[right].position);
        const SurfacePoint middle  = surface.evaluate(
          {(alpha_left[0] + alpha_right[0]) / 2, alpha_left[1]});
        if (side == 0)
          {
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                stations.axes[i][j] = middle.frame[j][i];
            stations.spin = middle.lame[1] /
                            (2 * std::abs(geometry.vertices[left].slope[1]) *
                             points[left].lame[1]) *
                            middle.connection(1);
          }
        for (const unsigned int q : {left, right})
          {
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                stations.at_side[q][i][j] =
                  middle.frame[i] * points[q].frame[j];
            stations.at_middle[q] = unit_symmetric_tensor<3>();
          }

        for (unsigned int face = 0; face < 2; ++face)
          {
            const auto position = [&](const SurfacePoint &at,
                                      const double        height) {
              return middle.to_frame(at.position + height * at.frame[2] -
                                     stations.origin);
            };
            const double height_left  = face_heights[left][face],
                         height_right = face_heights[right][face];
            auto &of_face             = stations.positions[face];
            of_face[0][side]          = position(points[left], height_left);
            of_face[2][side]          = position(points[right], height_right);
            of_face[1][side] =
              position(middle, (height_left + height_right) / 2);
          }
      }
  }


  void
  ShellFEValues::interpolate_positions(const FaceHeights &face_heights,
                                       const double       wall_thickness)
  {
    const auto position = [&](const unsigned int q, const unsigned int face) {
      return points[q].position + face_heights[q][face] * points[q].frame[2];
    };
    for (unsigned int q = 0; q < 4; ++q)
      for (unsigned int a = 0; a < 2; ++a)
        {
          ElementGeometry::Vertex &vertex = geometry.vertices[q];
          vertex.connection[a].clear();
          for (unsigned int face = 0; face < 2; ++face)
            {
              Tensor<1, 3> &tangent = vertex.metric.tangents[face][a];
              tangent               = vertex.slope[a] *
                        ((position(q, face) - position(q ^ (1 << a), face)) *
                         vertex.axes);
              // at constant alpha_3, where the director is e_3
              tangent[2] -= vertex.face_slope[face][a];
              tangent /= vertex.metric.zeta[face][a];
            }
        }

    geometry.quadrilateral = make_quadrilateral(
      {points, face_heights, center.frame[0], wall_thickness},
      geometry.formulation,
      geometry.normal_thickness);
    geometry.weight = geometry.quadrilateral->area();
    geometry.vertex_areas.fill(geometry.weight / 4);
    // the modes of lines of curvature are components in their frame
    Assert(geometry.quadrilateral->get_tangents().are_axes(),
           ExcMessage("The sides of cells must be coordinate lines."));
  }
} // namespace Biface
