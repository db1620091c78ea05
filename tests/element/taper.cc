// SPDX-License-Identifier: LGPL-2.1-or-later

// A wedge, whose faces are not parallel to the reference surface, has exact
// Green-Lagrange strains in a homogeneous deformation, and none in a rigid
// motion.

#include <deal.II/physics/transformations.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The maximum deviation of all modes of all cells from the exact ones. */
  double
  deviation(const std::vector<TestCell> &cells,
            const FaceHeights           &faces,
            const Tensor<2, 3>          &F)
  {
    using namespace Resultants;

    const Tensor<2, 3> C = transpose(F) * F;
    Resultants::Vector exact;
    for (unsigned int face = 0; face < 2; ++face)
      {
        for (unsigned int a = 0; a < 2; ++a)
          {
            exact[tangential(a, face)] = (C[a][a] - 1) / 2;
            exact[transverse(a, face)] = C[a][2];
          }
        exact[tangential(2, face)] = C[0][1];
      }
    exact[thickness] = (C[2][2] - 1) / 2;

    double result = 0;
    for (const TestCell &cell : cells)
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const SurfacePoint &point = cell.points[v];
              const Tensor<1, 3>  x =
                point.position +
                faces(point.position[0])[face] * point.frame[2];
              const Tensor<1, 3> u = point.to_frame(F * x - x);
              add_face_displacement(u, v, face, V);
            }
        result = std::max(
          result,
          (MixedElement(cell.geometry, V).strain() - Modes::constant(exact))
            .norm());
      }
    return result;
  }
} // namespace


int
main()
{
  const FaceHeights faces = [](const double x) {
    return std::array<double, 2>{{-0.5 - 0.1 * x, 0.3 + 0.25 * x}};
  };
  const auto cells = make_cells(Plane(), {{"0:3:2:1.3", "0:2:2"}}, faces);

  const Tensor<2, 3> R =
    Physics::Transformations::Rotations::rotation_matrix_3d(
      Point<3>(1, 2, -2) / 3., 1.2);
  // nothing special about this one
  const Tensor<2, 3> F(
    {{1.2, 0.3, -0.1}, {0.05, 0.9, 0.2}, {-0.15, 0.1, 1.05}});

  check_small("strains of a rotation", deviation(cells, faces, R), 1e-13);
  check_small("strains of a homogeneous deformation, less exact ones",
              deviation(cells, faces, F),
              1e-13);
}
