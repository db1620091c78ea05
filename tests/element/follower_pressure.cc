// SPDX-License-Identifier: LGPL-2.1-or-later

// On a rotated and stretched flat plate, the force of a follower pressure is
// the pressure times the current area and normal.

#include <deal.II/physics/transformations.h>

#include <biface/element/follower_pressure.h>

#include "../tests.h"
#include "one_cell.h"

using namespace dealii;
using namespace Biface;

int
main()
{
  const Plane surface;
  const auto  cells =
    make_cells(surface, {{"0:3:2:1.3", "0:2:2"}}, {{-0.1, 0.1}});

  // stretch by 1.5 along x, then rotate
  const Tensor<2, 3> R =
    Physics::Transformations::Rotations::rotation_matrix_3d(
      Point<3>(1, 2, 2) / 3., 0.7);
  Tensor<2, 3> F = R;
  for (unsigned int i = 0; i < 3; ++i)
    F[i][0] *= 1.5;

  Tensor<1, 3> force;
  for (const TestCell &cell : cells)
    {
      MixedElement::NodalVector V;
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int face = 0; face < 2; ++face)
          {
            const Point<3> X =
              cell.points[v].position +
              (face == 0 ? -0.1 : 0.1) * cell.points[v].frame[2];
            const Tensor<1, 3> u = F * X - X;
            add_face_displacement(u, v, face, V);
          }
      const auto nodal = FollowerPressure(cell.geometry, V).force();
      for (unsigned int v = 0; v < 4; ++v)
        force += MixedElement::face_force(nodal, v, Resultants::inner);
    }

  const Tensor<1, 3> expected = 3 * 1.5 * 2 * (R * Tensor<1, 3>({0, 0, 1}));
  check_small("force", (force - expected).norm(), 1e-13, expected.norm());
}
