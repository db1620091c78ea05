// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/element/quadrilateral.h>
#include <biface/element/quadrilateral_geometry.h>

namespace Biface
{
  using namespace dealii;

  Tensor<2, 3>
  in_columns(const SurfacePoint &point)
  {
    Tensor<2, 3> axes;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        axes[i][j] = point.frame[j][i];
    return axes;
  }


  namespace
  {
    Tensor<1, 3>
    face_position(const QuadrilateralPoints &points,
                  const unsigned int         q,
                  const unsigned int         face)
    {
      const SurfacePoint &at = points.vertices[q];
      return at.position + points.heights[q][face] * at.frame[2];
    }
  } // namespace


  namespace
  {
    /** The integrals of the shape functions over the middle surface, as it is
     * seen along the normal of the cell. */
    std::array<double, 4>
    areas_of_vertices(const QuadrilateralPoints &points,
                      const Tensor<1, 3>        &normal)
    {
      Tensor<1, 3> along, across, hourglass;
      for (unsigned int q = 0; q < 4; ++q)
        {
          const Tensor<1, 3> middle =
            (face_position(points, q, 0) + face_position(points, q, 1)) / 8;
          const int xi = (q & 1 ? 1 : -1), eta = (q & 2 ? 1 : -1);
          along += xi * middle;
          across += eta * middle;
          hourglass += xi * eta * middle;
        }
      const double constant = cross_product_3d(along, across) * normal,
                   by_xi    = cross_product_3d(along, hourglass) * normal,
                   by_eta   = cross_product_3d(hourglass, across) * normal;
      std::array<double, 4> areas;
      for (unsigned int q = 0; q < 4; ++q)
        areas[q] =
          constant + ((q & 1 ? 1 : -1) * by_xi + (q & 2 ? 1 : -1) * by_eta) / 3;
      return areas;
    }
  } // namespace


  namespace
  {
    /** The area between the sides at a vertex, of a face or of the mean of two
     * faces. */
    double
    area_at(const QuadrilateralPoints         &points,
            const unsigned int                 q,
            const std::array<unsigned int, 2> &faces)
    {
      const auto position = [&](const unsigned int vertex) {
        return (face_position(points, vertex, faces[0]) +
                face_position(points, vertex, faces[1])) /
               2;
      };
      return cross_product_3d(position(q ^ 1) - position(q),
                              position(q ^ 2) - position(q))
        .norm();
    }
  } // namespace


  const CellTangents *
  ElementGeometry::tangents() const
  {
    return along_lines ? nullptr : &quadrilateral->get_tangents();
  }


  std::shared_ptr<const Quadrilateral>
  make_quadrilateral(const QuadrilateralPoints &points,
                     const Formulation          formulation,
                     const bool                 normal_thickness)
  {
    Quadrilateral::Shape shape;
    for (unsigned int q = 0; q < 4; ++q)
      {
        shape.positions[q] = points.vertices[q].position;
        shape.normals[q]   = points.vertices[q].frame[2];
      }
    shape.heights   = points.heights;
    shape.direction = points.direction;
    Quadrilateral::Options options;
    options.means          = (formulation == Formulation::standard);
    options.mean_director  = normal_thickness;
    options.wall_thickness = points.wall_thickness;
    return std::make_shared<const Quadrilateral>(shape, options);
  }


  ElementGeometry::Stations
  straight_stations(const QuadrilateralPoints &points)
  {
    ElementGeometry::Stations stations;
    // a frame that does not turn needs no axis
    const SurfacePoint &frame = points.vertices[0];
    stations.origin           = frame.position;
    stations.axes             = in_columns(frame);
    for (unsigned int q = 0; q < 4; ++q)
      {
        stations.at_side[q] =
          transpose(stations.axes) * in_columns(points.vertices[q]);
        stations.at_middle[q] = stations.at_side[q];
      }
    for (unsigned int face = 0; face < 2; ++face)
      for (unsigned int side = 0; side < 2; ++side)
        {
          auto &of_face = stations.positions[face];
          for (const unsigned int end : {0, 1})
            of_face[2 * end][side] = frame.to_frame(
              face_position(points, 2 * side + end, face) - stations.origin);
          of_face[1][side] = (of_face[0][side] + of_face[2][side]) / 2;
        }
    return stations;
  }


  ElementGeometry
  quadrilateral_geometry(const QuadrilateralPoints &points,
                         const bool                 normal_thickness)
  {
    ElementGeometry geometry;
    geometry.normal_thickness = normal_thickness;
    geometry.quadrilateral =
      make_quadrilateral(points, geometry.formulation, normal_thickness);
    geometry.along_lines = false;
    geometry.weight      = geometry.quadrilateral->area();
    geometry.stations    = straight_stations(points);
    geometry.vertex_areas =
      areas_of_vertices(points, geometry.quadrilateral->material_frame()[2]);
    for (unsigned int q = 0; q < 4; ++q)
      {
        ElementGeometry::Vertex &vertex = geometry.vertices[q];
        vertex.axes                     = in_columns(points.vertices[q]);
        vertex.thickness  = points.heights[q][1] - points.heights[q][0];
        vertex.slope      = {};
        vertex.face_slope = {};
        vertex.metric     = ThicknessMetric({{0, 0}}, points.heights[q]);
        // only the ratio of areas counts
        vertex.metric.zeta_bar = {{1, 1}};
        for (unsigned int face = 0; face < 2; ++face)
          vertex.metric.zeta[face].fill(std::sqrt(
            area_at(points, q, {{face, face}}) / area_at(points, q, {{0, 1}})));
      }
    return geometry;
  }
} // namespace Biface
