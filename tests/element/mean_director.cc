// SPDX-License-Identifier: LGPL-2.1-or-later

// With the thickness strain of the mean director, and with that of the distance
// along the normal, forces and tangent are the derivatives of the energy, and
// rigid motions cause no strain. A director that alternates between vertices
// has the mean square of its interpolation in short cells, and that of the
// vertices in long ones.

#include <cmath>

#include <biface/laminate/layup.h>

#include "one_cell.h"
#include "some_vector.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  using NodalVector = MixedElement::NodalVector;

  ElementGeometry
  with(const ThicknessStrain thickness_strain, ElementGeometry geometry)
  {
    geometry.thickness_strain = thickness_strain;
    return geometry;
  }


  void
  test_derivatives(const ElementGeometry &geometry)
  {
    const ModeStiffness stiffness(
      Layup(Layup::Parameters(), cord_ply()).laminate(0).stiffness(),
      geometry.sampling);
    const NodalVector V = some_vector<24>(0.3, 1), dV = some_vector<24>(0.3, 2);
    const MixedElement  element(geometry, V);
    const Modes::Vector H_0 =
      some_vector<Modes::n>(stiffness.resultants(element.strain()).norm(), 3);

    // the strains of the mean director are quadratic, so that any step is exact
    const bool is_quadratic =
      (geometry.thickness_strain == ThicknessStrain::mean_director);
    const double        length    = is_quadratic ? 1 : 1e-4;
    const Modes::Vector variation = element.strain_variation(dV);
    const Modes::Vector difference =
      (MixedElement(geometry, V + length * dV).strain() -
       MixedElement(geometry, V - length * dV).strain()) /
      (2 * length);
    check_small("  variation of the strains",
                (variation - difference).norm(),
                is_quadratic ? 1e-13 : 1e-8,
                variation.norm());

    const double step     = 1e-4;
    const auto   force_at = [&](const NodalVector &V) {
      const MixedElement element(geometry, V);
      return element.internal_force(stiffness.resultants(element.strain()),
                                    H_0);
    };
    const auto energy_at = [&](const NodalVector &V) {
      const MixedElement  element(geometry, V);
      const Modes::Vector E = element.strain();
      return geometry.weight *
             (Modes::mean_product(stiffness.resultants(E), E) / 2 +
              Modes::mean_product(H_0, element.nonlinear_strain()));
    };
    check_small("  internal force",
                force_at(V) * dV -
                  (energy_at(V + step * dV) - energy_at(V - step * dV)) /
                    (2 * step),
                1e-7,
                force_at(V).norm() * dV.norm());

    const Modes::Vector       H = stiffness.resultants(element.strain()) + H_0;
    MixedElement::NodalMatrix K{};
    element.add_tangent(stiffness, H, K);
    const NodalVector exact =
      (force_at(V + step * dV) - force_at(V - step * dV)) / (2 * step);
    NodalVector by_matrix;
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        by_matrix[i] += K[i][j] * dV[j];
    check_small("  tangent", (by_matrix - exact).norm(), 1e-7, exact.norm());
    check_small("  product with the tangent",
                (by_matrix - element.tangent_product(stiffness, H, dV)).norm(),
                1e-12,
                by_matrix.norm());
  }


  /** Turn a cell as a whole. */
  void
  test_rotation(const TestCell              &cell,
                const std::array<double, 2> &heights,
                const ElementGeometry       &geometry)
  {
    const double angle = 0.7;
    NodalVector  V;
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int face = 0; face < 2; ++face)
        {
          const SurfacePoint &point = cell.points[v];
          const Point<3> x = point.position + heights[face] * point.frame[2];
          const Point<3> turned(std::cos(angle) * x[0] - std::sin(angle) * x[1],
                                std::sin(angle) * x[0] + std::cos(angle) * x[1],
                                x[2]);
          add_face_displacement(point.to_frame(turned - x), v, face, V);
        }
    check_small("  strains of a rigid rotation",
                MixedElement(geometry, V).strain().norm(),
                1e-12);
  }


  /** A director that turns by small angles of opposite sign along one
   * coordinate. */
  void
  test_mean(const std::string &length, const double part)
  {
    const double   h = 2, slope = 1e-2;
    const TestCell cell =
      make_cells(Plane(), {{"0:" + length + ":1", "0:1:1"}}, [&](const double) {
        return std::array<double, 2>{{0, h}};
      })[0];
    NodalVector V;
    for (unsigned int v = 0; v < 4; ++v)
      V[MixedElement::dof(v, 0, MixedElement::half_difference)] =
        (v % 2 == 0 ? -1 : 1) * slope * h / 2;
    const double E_33 =
      MixedElement(with(ThicknessStrain::mean_director, cell.geometry), V)
        .strain()[Resultants::thickness];
    check_small("thickness strain, length " + length,
                E_33 - part * slope * slope / 2,
                2e-3,
                slope * slope / 2);
  }
} // namespace


int
main()
{
  const std::array<std::string, 2> intervals{{"40:45:1", "10:15:1"}};
  const std::array<double, 2>      heights{{-1, 3.8}};
  for (const auto &[sampling, interpolation] : all_elements())
    {
      std::cout << "sampling: " << name_of(sampling)
                << ", interpolation: " << name_of(interpolation) << std::endl;
      const TestCell cell = make_cells(
        torus(),
        intervals,
        [&](const double) { return heights; },
        sampling,
        interpolation)[0];
      for (const auto thickness_strain :
           {ThicknessStrain::mean_director, ThicknessStrain::normal})
        {
          const ElementGeometry geometry =
            with(thickness_strain, cell.geometry);
          test_derivatives(geometry);
          if (interpolation == Interpolation::Cartesian)
            test_rotation(cell, heights, geometry);
        }
    }
  test_mean("0.05", 1. / 3);
  test_mean("500", 1);
}
