// SPDX-License-Identifier: LGPL-2.1-or-later

// On a rotated and stretched flat plate, the force of a follower pressure is
// the pressure times the current area and normal. On a closed torus in any
// shape, the forces are the gradient of a volume: their derivative is
// symmetric; with the standard formulation that of the volume within the
// bilinear faces, without a resultant. With that of the paper, four cells
// around the axis are enough for the volume of a torus that grows.

#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/physics/transformations.h>

#include <biface/element/follower_pressure.h>

#include "../tests.h"
#include "one_cell.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** A torus that is closed although its cells are not joined along one
   * meridian and one circle. */
  struct ClosedTorus
  {
    ClosedTorus(const std::array<std::string, 2> &intervals,
                const Formulation                 formulation)
      : cells(make_cells(torus(), intervals, {{-1, 3}}, formulation))
    {
      for (const TestCell &cell : cells)
        {
          nodes.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            {
              const SurfacePoint &point = cell.points[v];
              unsigned int        node  = 0;
              while (node < points.size() &&
                     points[node].position.distance(point.position) > 1e-6)
                ++node;
              if (node == points.size())
                points.push_back(point);
              nodes.back()[v] = node;
            }
        }
    }

    /** The displacements of the nodes of a cell, on one face. */
    MixedElement::NodalVector
    values(const std::vector<Tensor<1, 3>> &v,
           const unsigned int               c,
           const Resultants::Face           face) const
    {
      MixedElement::NodalVector V;
      for (unsigned int q = 0; q < 4; ++q)
        add_face_displacement(v[nodes[c][q]], q, face, V);
      return V;
    }

    /** The forces of a unit pressure. */
    std::vector<Tensor<1, 3>>
    forces(const std::vector<Tensor<1, 3>> &v,
           const Resultants::Face           face) const
    {
      std::vector<Tensor<1, 3>> result(points.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          const FollowerPressure pressure(
            cells[c].geometry, values(v, c, face), face);
          for (unsigned int q = 0; q < 4; ++q)
            result[nodes[c][q]] +=
              MixedElement::face_force(pressure.force(), q, face);
        }
      return result;
    }

    FullMatrix<double>
    derivative(const std::vector<Tensor<1, 3>> &v,
               const Resultants::Face           face) const
    {
      FullMatrix<double> K(3 * points.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          MixedElement::NodalMatrix of_cell;
          for (auto &row : of_cell)
            row.fill(0);
          FollowerPressure(cells[c].geometry, values(v, c, face), face)
            .add_derivative(1, of_cell);
          for (unsigned int q = 0; q < 4; ++q)
            for (unsigned int r = 0; r < 4; ++r)
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  K(3 * nodes[c][q] + i, 3 * nodes[c][r] + j) +=
                    of_cell[MixedElement::dof(q, i, MixedElement::mean)]
                           [MixedElement::dof(r, j, MixedElement::mean)];
        }
      return K;
    }

    Tensor<1, 3>
    position(const std::vector<Tensor<1, 3>> &v,
             const unsigned int               node,
             const Resultants::Face           face) const
    {
      Tensor<1, 3> components = v[node];
      components[2] += (face == Resultants::inner ? -1 : 3);
      return points[node].position + points[node].from_frame(components);
    }

    /** The volume within bilinear faces. */
    double
    volume(const std::vector<Tensor<1, 3>> &v,
           const Resultants::Face           face) const
    {
      double sum = 0;
      for (const auto &of_cell : nodes)
        {
          std::array<Tensor<1, 3>, 4> p;
          for (unsigned int q = 0; q < 4; ++q)
            p[q] = position(v, of_cell[q], face);
          for (const double s : {-1., 1.})
            for (const double t : {-1., 1.})
              {
                const double a       = (1 + s / std::sqrt(3)) / 2,
                             b       = (1 + t / std::sqrt(3)) / 2;
                const Tensor<1, 3> x = (1 - b) * ((1 - a) * p[0] + a * p[1]) +
                                       b * ((1 - a) * p[2] + a * p[3]);
                sum += x *
                       cross_product_3d(
                         (1 - b) * (p[1] - p[0]) + b * (p[3] - p[2]),
                         (1 - a) * (p[2] - p[0]) + a * (p[3] - p[1])) /
                       12;
              }
        }
      return face == Resultants::inner ? sum : -sum;
    }

    std::vector<TestCell>                    cells;
    std::vector<std::array<unsigned int, 4>> nodes;
    std::vector<SurfacePoint>                points;
  };


  std::vector<Tensor<1, 3>>
  some_vectors(const unsigned int n, const double size, const unsigned int seed)
  {
    std::vector<Tensor<1, 3>> result(n);
    for (unsigned int i = 0; i < 3 * n; ++i)
      result[i / 3][i % 3] = size * some_number(i + seed);
    return result;
  }


  double
  work(const std::vector<Tensor<1, 3>> &forces,
       const std::vector<Tensor<1, 3>> &v)
  {
    double sum = 0;
    for (unsigned int n = 0; n < v.size(); ++n)
      sum += forces[n] * v[n];
    return sum;
  }


  void
  test_closed_torus(const Formulation formulation, const Resultants::Face face)
  {
    std::cout << name_of(formulation)
              << (face == Resultants::inner ? ", inner" : ", outer") << " face"
              << std::endl;
    // cells of about 25 by 30
    const ClosedTorus  shell({{"-180:180:12:1.1", "-180:180:28"}}, formulation);
    const unsigned int n              = shell.points.size();
    const std::vector<Tensor<1, 3>> v = some_vectors(n, 8, 1);
    check_true("  closed", n == 12 * 28);

    const auto K    = shell.derivative(v, face);
    double     skew = 0;
    for (unsigned int i = 0; i < 3 * n; ++i)
      for (unsigned int j = 0; j < 3 * n; ++j)
        skew = std::hypot(skew, K(i, j) - K(j, i));
    check_small("  skew part of the tangent", skew, 1e-13, K.frobenius_norm());

    const auto     dv    = some_vectors(n, 1, 100);
    const double   small = 1e-3;
    Vector<double> direction(3 * n), product(3 * n);
    auto           before = v, after = v;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int c = 0; c < 3; ++c)
          direction(3 * i + c) = dv[i][c];
        before[i] -= small * dv[i];
        after[i] += small * dv[i];
      }
    K.vmult(product, direction);
    const auto f = shell.forces(v, face), f_0 = shell.forces(before, face),
               f_1   = shell.forces(after, face);
    double deviation = 0;
    for (unsigned int i = 0; i < 3 * n; ++i)
      deviation = std::hypot(
        deviation, product(i) - (f_1[i / 3] - f_0[i / 3])[i % 3] / (2 * small));
    check_small(
      "  tangent against differences", deviation, 1e-8, product.l2_norm());

    if (formulation == Formulation::paper)
      return;
    check_small("  work against the change of the volume",
                (shell.volume(after, face) - shell.volume(before, face)) /
                    (2 * small) -
                  work(f, dv),
                1e-8,
                work(f, dv));
    Tensor<1, 3> force, moment;
    double       size = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        const Tensor<1, 3> F = shell.points[i].from_frame(f[i]);
        force += F;
        moment += cross_product_3d(shell.position(v, i, face), F);
        size += F.norm();
      }
    check_small("  resultant", force.norm() + moment.norm() / 250, 1e-13, size);
  }


  /** All nodes of a torus move outward; its volume is known. */
  void
  test_growing_torus()
  {
    std::cout << "four cells around the axis" << std::endl;
    const auto                      face = Resultants::inner;
    const ClosedTorus               shell({{"-180:180:24", "-180:180:4"}},
                            Formulation::paper);
    const unsigned int              n = shell.points.size();
    const double                    w = 4;
    const std::vector<Tensor<1, 3>> outward(n, Tensor<1, 3>({0, 0, 1}));
    std::vector<Tensor<1, 3>>       v(n);
    for (Tensor<1, 3> &of_node : v)
      of_node[2] = w;
    // derivative of 2 pi^2 R r^2
    const double expected = 4 * numbers::PI * numbers::PI * 200 * (50 - 1 + w);
    check_small("  derivative of the volume",
                work(shell.forces(v, face), outward) - expected,
                1e-4,
                expected);
  }
} // namespace


int
main()
{
  for (const auto formulation : {Formulation::paper, Formulation::standard})
    for (const auto face : {Resultants::inner, Resultants::outer})
      test_closed_torus(formulation, face);
  test_growing_torus();

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
