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

  LA::Vector
  forces_on_planes(const ShellMesh            &mesh,
                   const Resultants::Face      face,
                   const std::vector<Edge>    &edges,
                   const std::optional<double> radius)
  {
    LA::Vector         result = mesh.owned_vector();
    const Tensor<1, 3> axis   = mesh.get_surface().axis();
    for (const BoundarySegment &segment : mesh.boundary)
      if (std::find(edges.begin(), edges.end(), segment.edge) != edges.end())
        for (const unsigned int n : segment.nodes)
          {
            const Node         &node    = mesh.nodes[n];
            const SurfacePoint &surface = node.surface;
            const Tensor<1, 3>  x(surface.position +
                                 node.face_heights[face] * surface.frame[2]);
            const Tensor<1, 3>  arm = x - (x * axis) * axis;
            // half of the area within the side of a cell, which is straight if
            // positions are interpolated
            const double angle = segment.length / surface.lame[1];
            const double area =
              (radius ? *radius * *radius * angle
                      : arm.norm_square() *
                          (mesh.interpolation == Interpolation::Cartesian
                             ? std::sin(angle)
                             : angle)) /
              4;

            // away from the cavity, which is on the side of the face
            const Tensor<1, 3> of_axis =
              surface.position - (surface.position * axis) * axis;
            const bool at_end = (segment.edge == Edge::alpha_1_max);
            const bool follows =
              cross_product_3d(axis, of_axis) * surface.frame[1] > 0;
            const double outward = (follows == at_end ? -1. : 1.) *
                                   (face == Resultants::inner ? 1. : -1.);

            const Tensor<1, 3> force = surface.to_frame(outward * area * axis);
            for (unsigned int i = 0; i < 3; ++i)
              {
                std::vector<double> values{force[i]};
                for (const double part : node.thickness_weights())
                  values.push_back(part * force[i]);
                const auto *first = &node.dofs[node.position(i, 0)];
                result.add(std::vector<types::global_dof_index>(
                             first, first + node.n_parts()),
                           values);
              }
          }
    result.compress(VectorOperation::add);
    return result;
  }
} // namespace Biface
