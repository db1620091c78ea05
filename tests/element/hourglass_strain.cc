// SPDX-License-Identifier: LGPL-2.1-or-later

// In a plate, an increment that alternates from node to node has no other
// nonlinear strains than those of its hourglass, and one with constant
// gradients has none of these.

#include <biface/laminate/resultants.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The same displacement of both faces at each vertex. */
  MixedElement::NodalVector
  displacement(const TestCell                                      &cell,
               const std::function<Tensor<1, 3>(const Point<3> &)> &u)
  {
    MixedElement::NodalVector V;
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int face = 0; face < 2; ++face)
        add_face_displacement(u(cell.points[v].position), v, face, V);
    return V;
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto cell =
    make_cells(Plane(), {{"-1:1:1", "-1.5:1.5:1"}}, [](const double) {
      return std::array<double, 2>{{-0.2, 0.2}};
    })[0];
  const MixedElement at_rest(cell.geometry, MixedElement::NodalVector());
  const auto         nonlinear = [&](const MixedElement::NodalVector &V) {
    return MixedElement(cell.geometry, V).nonlinear_strain();
  };

  Tensor<1, 3> direction;
  direction[0] = 0.3;
  direction[1] = -0.2;
  direction[2] = 0.5;

  const auto hourglass = displacement(
    cell, [&](const Point<3> &x) { return x[0] * x[1] * direction; });
  const auto all = nonlinear(hourglass);
  check_small("alternating: difference",
              (at_rest.hourglass_strain(hourglass) - all).norm(),
              1e-14,
              all.norm());

  const auto constant = displacement(
    cell, [&](const Point<3> &x) { return (2 * x[0] - x[1]) * direction; });
  check_small("constant gradients: hourglass",
              at_rest.hourglass_strain(constant).norm(),
              1e-14,
              nonlinear(constant).norm());
}
