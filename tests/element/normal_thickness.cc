// SPDX-License-Identifier: LGPL-2.1-or-later

// With the thickness strain of the distance of the faces along the normal,
// forces and tangent are the derivatives of the energy, and rigid motions cause
// no strain. The director that it starts from has, where it alternates between
// vertices, the mean square of its interpolation in short cells, and that of
// the vertices in long ones.

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

  void
  test_derivatives(const ElementGeometry &geometry)
  {
    const ModeStiffness stiffness(
      Layup(Layup::Parameters(), cord_ply()).laminate(0).stiffness(),
      geometry.formulation);
    const NodalVector V = some_vector<24>(0.3, 1), dV = some_vector<24>(0.3, 2);
    const MixedElement  element(geometry, V);
    const Modes::Vector H_0 =
      some_vector<Modes::n>(stiffness.resultants(element.strain()).norm(), 3);

    const double        step      = 1e-4;
    const Modes::Vector variation = element.strain_variation(dV);
    const Modes::Vector difference =
      (MixedElement(geometry, V + step * dV).strain() -
       MixedElement(geometry, V - step * dV).strain()) /
      (2 * step);
    check_small("  variation of the strains",
                (variation - difference).norm(),
                1e-8,
                variation.norm());

    const ElasticElement elastic{geometry, stiffness, H_0};
    const auto           force_at = [&](const NodalVector &V) {
      return elastic.force(V);
    };
    check_small("  internal force",
                force_at(V) * dV - (elastic.energy(V + step * dV) -
                                    elastic.energy(V - step * dV)) /
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
  test_rotation(const TestCell &cell, const std::array<double, 2> &heights)
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
                MixedElement(cell.geometry, V).strain().norm(),
                1e-12);
  }


  /** A director that turns by small angles of opposite sign along one
   * coordinate. */
  void
  test_director(const Formulation  formulation,
                const std::string &length,
                const double       part)
  {
    const double h = 2, slope = 1e-2;
    TestCell     cell = make_cells(Plane(),
                               {{"0:" + length + ":1", "0:1:1"}},
                               {{0, h}},
                               formulation,
                               true)[0];
    // without what NormalThickness subtracts
    cell.geometry.normal_thickness = false;
    NodalVector V;
    for (unsigned int v = 0; v < 4; ++v)
      V[MixedElement::dof(v, 0, MixedElement::half_difference)] =
        (v % 2 == 0 ? -1 : 1) * slope * h / 2;
    const double E_33 =
      MixedElement(cell.geometry, V).strain()[Resultants::thickness];
    check_small("director, length " + length,
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
  for (const auto formulation : {Formulation::vertices, Formulation::standard})
    {
      std::cout << "formulation: " << name_of(formulation) << std::endl;
      const TestCell cell =
        make_cells(torus(), intervals, heights, formulation, true)[0];
      test_derivatives(cell.geometry);
      test_rotation(cell, heights);
      test_director(formulation, "0.05", 1. / 3);
      test_director(formulation, "500", 1);
    }
}
