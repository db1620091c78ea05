// SPDX-License-Identifier: LGPL-2.1-or-later

// Directors that tilt in turn by an angle have the tilt A sin^2/2 on a thin
// cell, whatever its thickness, and less where the thickness strain is that of
// the mean director. Rigid motions of a curved cell have none, its gradient
// and its second derivative are those of its values, and the mean of the
// gradient between two states gives their difference.

#include <deal.II/physics/transformations.h>

#include <biface/element/director_tilt.h>

#include "../tests.h"
#include "one_cell.h"
#include "some_vector.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** Directors that turn by an angle in turn and are stretched, about a middle
   * surface at rest. */
  double
  of_directors_in_turn(const TestCell &cell,
                       const double    angle,
                       const double    stretch = 1)
  {
    MixedElement::NodalVector V;
    for (unsigned int q = 0; q < 4; ++q)
      {
        const double sign = (q == 0 || q == 3 ? 1 : -1), h = 4;
        V[MixedElement::dof(q, 0, MixedElement::half_difference)] =
          h / 2 * stretch * sign * std::sin(angle);
        V[MixedElement::dof(q, 2, MixedElement::half_difference)] =
          h / 2 * (stretch * std::cos(angle) - 1);
      }
    return DirectorTilt(cell.geometry).value(V);
  }
} // namespace


int
main()
{
  const double angle = 0.3, square = std::sin(angle) * std::sin(angle);
  const std::array<std::string, 2> cell_of_6_times_8{{"0:6:1", "0:8:1"}};
  check_small("tilt in turn",
              of_directors_in_turn(make_cells(Plane(),
                                              cell_of_6_times_8,
                                              {{-1, 3}},
                                              Formulation::standard)[0],
                                   angle) -
                48 * square / 2,
              1e-14,
              48);
  check_small("tilt in turn, half as thick",
              of_directors_in_turn(make_cells(Plane(),
                                              cell_of_6_times_8,
                                              {{-1, 3}},
                                              Formulation::standard)[0],
                                   angle,
                                   0.5) -
                48 * square / 2,
              1e-14,
              48);
  // 1 - 8/9 phi_1 phi_2 of the vertices
  check_small(
    "tilt in turn, mean director",
    of_directors_in_turn(
      make_cells(
        Plane(), cell_of_6_times_8, {{-1, 3}}, Formulation::standard, true)[0],
      angle) -
      48 * square * (0.5 - 4. / 9 / (1 + 36. / 16 / 12) / (1 + 64. / 16 / 12)),
    1e-14,
    48);

  const TestCell cell = make_cells(
    torus(), {{"20:50:1", "0:25:1"}}, {{-1, 3}}, Formulation::standard)[0];
  const DirectorTilt tilt(cell.geometry);

  const Tensor<2, 3> rotation =
    Physics::Transformations::Rotations::rotation_matrix_3d(
      Point<3>(Tensor<1, 3>({2, -1, 2}) / 3), 2.);
  MixedElement::NodalVector V;
  for (unsigned int q = 0; q < 4; ++q)
    for (unsigned int face = 0; face < 2; ++face)
      {
        const SurfacePoint &point = cell.points[q];
        const Tensor<1, 3>  x =
          point.position + (face == 0 ? -1 : 3) * point.frame[2];
        add_face_displacement(point.to_frame(rotation * x - x), q, face, V);
      }
  check_small("rigid motion", tilt.value(V), 1e-12, cell.geometry.weight);

  V                           = some_vector<MixedElement::n_dofs>(1, 1);
  const double              h = 1e-4;
  double                    gradient_error = 0, second_error = 0, norm = 0;
  MixedElement::NodalVector gradient;
  MixedElement::NodalMatrix second{};
  tilt.add_gradient(1, V, gradient);
  tilt.add_second_derivative(1, V, second);
  for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
    {
      MixedElement::NodalVector plus = V, minus = V, change;
      plus[j] += h;
      minus[j] -= h;
      gradient_error =
        std::max(gradient_error,
                 std::abs((tilt.value(plus) - tilt.value(minus)) / (2 * h) -
                          gradient[j]));
      tilt.add_gradient(1 / (2 * h), plus, change);
      tilt.add_gradient(-1 / (2 * h), minus, change);
      for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
        {
          second_error =
            std::max(second_error, std::abs(change[i] - second[i][j]));
          norm = std::max(norm, std::abs(second[i][j]));
        }
    }
  const MixedElement::NodalVector end =
    V + some_vector<MixedElement::n_dofs>(1, 2);
  MixedElement::NodalVector mean;
  tilt.add_mean_gradient(1, V, end, mean);
  check_small("mean gradient",
              mean * (end - V) - (tilt.value(end) - tilt.value(V)),
              1e-13,
              mean.norm() * (end - V).norm());
  check_small("gradient", gradient_error, 1e-7, gradient.norm());
  check_small("second derivative", second_error, 1e-7, norm);
}
