// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/element/follower_pressure.h>

namespace Biface
{
  using namespace dealii;

  FollowerPressure::FollowerPressure(const ElementGeometry           &geometry,
                                     const MixedElement::NodalVector &V,
                                     const Resultants::Face           face,
                                     const std::array<double, 4>     &pressure)
    : geometry(geometry), face(face), pressure(pressure)
  {
    for (unsigned int q = 0; q < 4; ++q)
      {
        const ElementGeometry::Vertex &vertex = geometry.vertices[q];
        const DisplacementGradient u = displacement_gradient(geometry, V, q);
        for (unsigned int a = 0; a < 2; ++a)
          {
            // along the face, which may be inclined to the reference surface
            tangents[q][a] = u.g[face][a] + vertex.face_slope[face][a] * u.beta;
            tangents[q][a] +=
              vertex.metric.zeta[face][a] * vertex.metric.tangents[face][a];
            tangents[q][a][2] += vertex.face_slope[face][a];
          }
        const Tensor<1, 3> force =
          weight(q) * cross_product_3d(tangents[q][0], tangents[q][1]);
        MixedElement::add_face_force(force, q, face, nodal_force);
      }
  }


  void
  FollowerPressure::add_derivative(const double               factor,
                                   MixedElement::NodalMatrix &K) const
  {
    for (unsigned int q = 0; q < 4; ++q)
      {
        const ElementGeometry::Vertex &vertex = geometry.vertices[q];

        // the derivative of t_1 x t_2 is that of one of the two tangents
        const auto change_of_cross_product = [&](const unsigned int  a,
                                                 const Tensor<1, 3> &dt) {
          return a == 0 ? cross_product_3d(dt, tangents[q][1])
                        : cross_product_3d(tangents[q][0], dt);
        };

        // each tangent depends on the vertex and on its neighbor along the
        // line, see ElementGeometry::derivative()
        Tensor<2, 3> own;
        for (unsigned int a = 0; a < 2; ++a)
          {
            Tensor<2, 3> neighbor;
            for (unsigned int j = 0; j < 3; ++j)
              {
                Tensor<1, 3> unit;
                unit[j]                   = vertex.slope[a];
                const Tensor<1, 3> by_own = change_of_cross_product(
                  a, unit + vertex.connection[a] * unit / vertex.slope[a]);
                const Tensor<1, 3> by_neighbor =
                  change_of_cross_product(a, -(vertex.turn[a] * unit));
                for (unsigned int i = 0; i < 3; ++i)
                  {
                    own[i][j] += by_own[i];
                    neighbor[i][j] = by_neighbor[i];
                  }
              }
            MixedElement::add_stiffness(factor * weight(q) * neighbor,
                                        q,
                                        MixedElement::face_sign[face],
                                        q ^ (1 << a),
                                        MixedElement::face_sign[face],
                                        K);
          }
        MixedElement::add_stiffness(factor * weight(q) * own,
                                    q,
                                    MixedElement::face_sign[face],
                                    q,
                                    MixedElement::face_sign[face],
                                    K);
      }
  }


  double
  FollowerPressure::weight(const unsigned int vertex) const
  {
    // the slopes are 1/(A_a times the change of alpha_a)
    const auto &slope = geometry.vertices[vertex].slope;
    return (face == Resultants::inner ? 1 : -1) * pressure[vertex] /
           (4 * std::abs(slope[0] * slope[1]));
  }
} // namespace Biface
