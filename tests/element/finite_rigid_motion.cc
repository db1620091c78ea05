// SPDX-License-Identifier: LGPL-2.1-or-later

// The strains at a point vanish in a finite rigid motion and have the exact
// Green-Lagrange values in a homogeneous deformation.

#include <deal.II/physics/transformations.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The derivatives of the torus' frame with respect to psi and phi, worked
   * out by hand: `[a][i]` is that of e_i. */
  std::array<std::array<Tensor<1, 3>, 3>, 2>
  frame_derivatives(const Point<2> &alpha)
  {
    const double c = std::cos(alpha[0]), s = std::sin(alpha[0]);
    const double C = std::cos(alpha[1]), S = std::sin(alpha[1]);

    const Tensor<1, 3> axis({0, 1, 0}), radial({C, 0, S}), around({-S, 0, C});
    // e_1 = -s radial + c axis, e_2 = around, e_3 = c radial + s axis
    return {{{{-c * radial - s * axis, Tensor<1, 3>(), -s * radial + c * axis}},
             {{-s * around, -radial, c * around}}}};
  }


  /** The strains of the deformation x -> F x + t, from the displacements of
   * the faces and their derivatives with respect to the coordinates. */
  Resultants::Vector
  strain(const Point<2>              &alpha,
         const Tensor<2, 3>          &F,
         const Tensor<1, 3>          &t,
         const std::array<double, 2> &faces)
  {
    const SurfaceOfRevolution surface = torus();
    const SurfacePoint        point   = surface.evaluate(alpha);
    const auto                e_a     = frame_derivatives(alpha);
    const Tensor<2, 3>        gradient =
      F - static_cast<Tensor<2, 3>>(unit_symmetric_tensor<3>());

    DisplacementGradient        u;
    std::array<Tensor<1, 3>, 2> v;
    for (unsigned int face = 0; face < 2; ++face)
      {
        const Tensor<1, 3> displacement =
          gradient * (point.position + faces[face] * point.frame[2]) + t;
        v[face] = point.to_frame(displacement);
        for (unsigned int a = 0; a < 2; ++a)
          {
            const Tensor<1, 3> derivative =
              gradient *
              (point.lame[a] * point.frame[a] + faces[face] * e_a[a][2]);
            // v_i = e_i . v, by the product rule
            Tensor<1, 3> v_a;
            for (unsigned int i = 0; i < 3; ++i)
              v_a[i] = e_a[a][i] * displacement + point.frame[i] * derivative;
            u.g[face][a] = v_a / point.lame[a] + point.connection(a) * v[face];
          }
      }
    u.beta = (v[1] - v[0]) / (faces[1] - faces[0]);
    return green_lagrange_strain(u, ThicknessMetric(point.curvature, faces));
  }
} // namespace


int
main()
{
  using namespace Resultants;

  const std::array<double, 2> faces{{-1.5, 4.8}};
  const Tensor<1, 3>          t({20, -300, 7});
  const Tensor<1, 3>          axis = Tensor<1, 3>({1, 2, -2}) / 3;
  const Tensor<2, 3>          R =
    Physics::Transformations::Rotations::rotation_matrix_3d(Point<3>(axis),
                                                            1.2);
  // nothing special about this one
  const Tensor<2, 3> F(
    {{1.2, 0.3, -0.1}, {0.05, 0.9, 0.2}, {-0.15, 0.1, 1.05}});
  const Tensor<2, 3> C = transpose(F) * F;

  double largest = 0, deviation = 0;
  for (const double psi : {-2., -0.5, 0., 1.1})
    for (const double phi : {-1., 0., 2.5})
      {
        const Point<2> alpha(psi, phi);
        largest = std::hypot(largest, strain(alpha, R, t, faces).norm());

        const SurfacePoint    point = torus().evaluate(alpha);
        const ThicknessMetric metric(point.curvature, faces);
        const auto component = [&](const unsigned int i, const unsigned int j) {
          return point.frame[i] * (C * point.frame[j]);
        };
        Resultants::Vector exact;
        for (unsigned int face = 0; face < 2; ++face)
          {
            for (unsigned int a = 0; a < 2; ++a)
              {
                exact[tangential(a, face)] = (component(a, a) - 1) / 2;
                exact[transverse(a, face)] =
                  metric.zeta[face][a] / metric.zeta_bar[a] * component(a, 2);
              }
            exact[tangential(2, face)] = component(0, 1);
          }
        exact[thickness] = (component(2, 2) - 1) / 2;
        deviation =
          std::hypot(deviation, (strain(alpha, F, t, faces) - exact).norm());
      }
  check_small("strains of a rigid motion", largest, 1e-12);
  check_small(
    "strains of a homogeneous deformation, less exact ones", deviation, 1e-12);
}
