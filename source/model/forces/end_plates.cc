// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/types.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <biface/model/forces/end_plates.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  Tensor<1, 3>
  half_of_plane(const ShellMesh            &mesh,
                const Resultants::Face      face,
                const BoundarySegment      &segment,
                const Node                 &node,
                const std::optional<double> radius)
  {
    const Tensor<1, 3>  axis    = mesh.get_surface().axis();
    const SurfacePoint &surface = node.surface;
    const Tensor<1, 3>  x(surface.position +
                         node.face_heights[face] * surface.frame[2]);
    const Tensor<1, 3>  arm = x - (x * axis) * axis;
    // within the side of a cell, which is straight if positions are
    // interpolated
    const double angle = segment.length / surface.lame[1];
    // half of the sector between the axis and the side, the other half is that
    // of its other node
    const double area =
      (radius ? *radius * *radius * angle
              : arm.norm_square() * (mesh.formulation != Formulation::paper
                                       ? std::sin(angle)
                                       : angle)) /
      4;

    // away from the cavity, which is on the side of the face
    const Tensor<1, 3> of_axis =
      surface.position - (surface.position * axis) * axis;
    const bool at_end  = segment.is_on(Edge::alpha_1_max);
    const bool follows = cross_product_3d(axis, of_axis) * surface.frame[1] > 0;
    const double outward =
      (follows == at_end ? -1. : 1.) * (face == Resultants::inner ? 1. : -1.);
    return surface.to_frame(outward * area * axis);
  }


  EndPlates::EndPlates(const ShellMesh &mesh, const PressureLoad &pressure)
    : at_unit_pressure(mesh.owned_vector())
  {
    const std::vector<Edge> &edges = pressure.end_plates;
    for (const BoundarySegment &segment : mesh.boundary)
      if (std::any_of(edges.begin(), edges.end(), [&](const Edge edge) {
            return segment.is_on(edge);
          }))
        for (const unsigned int n : segment.nodes)
          {
            const Node        &node = mesh.nodes[n];
            const Tensor<1, 3> force =
              half_of_plane(mesh, pressure.face, segment, node);
            // at the edge of the face, which ends the cavity, so that the work
            // is that of the gas
            const unsigned int face_of_wall = pressure.face * node.n_layers();
            for (unsigned int i = 0; i < 3; ++i)
              {
                std::vector<double> values;
                for (unsigned int part = 0; part < node.n_parts(); ++part)
                  values.push_back(Node::sign_of_part(face_of_wall, part) *
                                   force[i]);
                const auto *first = &node.dofs[node.position(i, 0)];
                at_unit_pressure.add(std::vector<types::global_dof_index>(
                                       first, first + node.n_parts()),
                                     values);
              }
          }
    at_unit_pressure.compress(VectorOperation::add);
  }
} // namespace Biface
