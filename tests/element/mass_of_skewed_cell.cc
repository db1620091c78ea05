// SPDX-License-Identifier: LGPL-2.1-or-later

// The kinetic energy of a flat cell of any convex shape that moves as a rigid
// body is exact: half of the integral of the density times the square of the
// velocity.

#include <deal.II/base/quadrature_lib.h>

#include <biface/element/element_mass.h>
#include <biface/element/quadrilateral_geometry.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double h = 0.4, rho = 3;
  // of two faces, between which velocities are linear
  const std::array<std::array<double, 2>, 2> moments{
    {{{rho * h / 3, rho * h / 6}}, {{rho * h / 6, rho * h / 3}}}};
  const std::array<Point<3>, 4> corners{{Point<3>(0, 0, 0),
                                         Point<3>(9, 2, 0),
                                         Point<3>(-2, 7, 0),
                                         Point<3>(4, 8, 0)}};
  QuadrilateralPoints           points;
  for (unsigned int q = 0; q < 4; ++q)
    {
      points.vertices[q].position = corners[q];
      points.vertices[q].frame    = {{Tensor<1, 3>({0.6, 0.8, 0}),
                                      Tensor<1, 3>({-0.8, 0.6, 0}),
                                      Tensor<1, 3>({0, 0, 1})}};
      points.heights[q]           = {{-h / 2, h / 2}};
    }
  points.direction                  = Tensor<1, 3>({1, 0, 0});
  const auto geometry               = quadrilateral_geometry(points, false);
  const MixedElement::NodalMatrix M = element_mass(geometry, moments);

  for (unsigned int k = 0; k < 6; ++k)
    {
      const auto velocity = [k](const Tensor<1, 3> &x) {
        Tensor<1, 3> axis;
        axis[k % 3] = 1;
        return k < 3 ? axis : cross_product_3d(axis, x);
      };
      MixedElement::NodalVector v;
      for (unsigned int q = 0; q < 4; ++q)
        {
          std::array<Tensor<1, 3>, 2> of_faces;
          for (unsigned int face = 0; face < 2; ++face)
            of_faces[face] =
              velocity(corners[q] +
                       points.heights[q][face] * points.vertices[q].frame[2]);
          for (unsigned int i = 0; i < 3; ++i)
            {
              const Tensor<1, 3> &e = points.vertices[q].frame[i];
              v[MixedElement::dof(q, i, MixedElement::mean)] =
                (of_faces[1] + of_faces[0]) * e / 2;
              v[MixedElement::dof(q, i, MixedElement::half_difference)] =
                (of_faces[1] - of_faces[0]) * e / 2;
            }
        }
      double energy = 0;
      for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
        for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
          energy += v[i] * M[i][j] * v[j] / 2;

      double          exact = 0;
      const QGauss<3> gauss(4);
      for (unsigned int g = 0; g < gauss.size(); ++g)
        {
          const Point<3>             &xi = gauss.point(g);
          Tensor<1, 3>                x;
          std::array<Tensor<1, 3>, 2> tangents;
          for (unsigned int q = 0; q < 4; ++q)
            {
              const double a = (q & 1) ? xi[0] : 1 - xi[0],
                           b = (q & 2) ? xi[1] : 1 - xi[1];
              x += a * b * corners[q];
              tangents[0] += ((q & 1) ? b : -b) * corners[q];
              tangents[1] += ((q & 2) ? a : -a) * corners[q];
            }
          x[2] = h * (xi[2] - 0.5);
          exact += gauss.weight(g) * rho * h *
                   cross_product_3d(tangents[0], tangents[1]).norm() *
                   velocity(x).norm_square() / 2;
        }
      check_small(
        k < 3 ? "translation" : "rotation", energy - exact, 1e-13, exact);
    }
}
