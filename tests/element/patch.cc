// SPDX-License-Identifier: LGPL-2.1-or-later

// Patch tests: on an irregular grid of a plate, states of constant stretch and
// curvature have exact resultants in every element, and forces that balance at
// the inner nodes.

#include <functional>
#include <map>

#include <biface/laminate/laminate.h>
#include <biface/laminate/material.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const double E = 1000, nu = 0.3, h = 2;

  const Laminate
    laminate({{{Material::isotropic(E, nu).stiffness("material")}, h, 0, {}}},
             ThicknessLaw::symmetric,
             0);

  /** Displacement at the position (x, y) and the height z over the inner
   * face. */
  using Field = std::function<Tensor<1, 3>(const Point<3> &)>;

  enum class Theory
  {
    nonlinear,
    linear
  };


  /**
   * @param stress the exact stresses 11, 22, 12 on the inner and the outer
   * face; those across the thickness vanish.
   */
  void
  test(const Formulation                          formulation,
       const std::string                         &name,
       const Theory                               theory,
       const Field                               &displacement,
       const std::array<std::array<double, 3>, 2> stress)
  {
    // int N^p N^q of a stress that is linear in the thickness
    Resultants::Vector exact;
    for (unsigned int ab = 0; ab < 3; ++ab)
      for (unsigned int p = 0; p < 2; ++p)
        exact[Resultants::tangential(ab, p)] =
          h / 6 * (2 * stress[p][ab] + stress[1 - p][ab]);

    const ModeStiffness stiffness(laminate.stiffness(), formulation);
    const auto          cells = make_cells(Plane(),
                                  {{"0:30:4:1.3", "-10:10:3:0.7, 10:16:1"}},
                                  laminate.face_heights(),
                                  formulation);

    std::map<unsigned int, std::array<Tensor<1, 3>, 2>> forces;
    std::map<unsigned int, unsigned int>                n_cells;
    double                                              deviation = 0;
    for (const TestCell &cell : cells)
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              Point<3> x = cell.points[v].position;
              x[2]       = laminate.face_heights()[face];
              add_face_displacement(displacement(x), v, face, V);
            }

        const MixedElement at_rest(cell.geometry, MixedElement::NodalVector());
        const MixedElement deformed(cell.geometry, V);
        const bool         linear = (theory == Theory::linear);

        const Modes::Vector H = stiffness.resultants(
          linear ? at_rest.strain_variation(V) : deformed.strain());
        deviation = std::hypot(deviation, (H - Modes::constant(exact)).norm());

        const auto force =
          (linear ? at_rest : deformed).internal_force(H, Modes::Vector());
        for (unsigned int v = 0; v < 4; ++v)
          {
            ++n_cells[cell.vertices[v]];
            for (unsigned int face = 0; face < 2; ++face)
              forces[cell.vertices[v]][face] +=
                MixedElement::face_force(force, v, face);
          }
      }

    double       inner = 0, edge = 0;
    unsigned int n_inner = 0;
    for (const auto &node : forces)
      for (const auto &force : node.second)
        if (n_cells[node.first] == 4)
          {
            inner = std::hypot(inner, force.norm());
            ++n_inner;
          }
        else
          edge = std::max(edge, force.norm());

    std::cout << name << std::endl;
    check_small("  resultants", deviation, 1e-11, exact.norm());
    check_small("  forces at inner nodes", inner, 1e-12, edge);
    check_true("  on both faces of nine of them", n_inner == 18);
  }


  /** Stresses of plane stress. */
  std::array<double, 3>
  stress(const double E_11, const double E_22, const double two_E_12)
  {
    return {{E / (1 - nu * nu) * (E_11 + nu * E_22),
             E / (1 - nu * nu) * (E_22 + nu * E_11),
             E / (2 * (1 + nu)) * two_E_12}};
  }

  void
  test_all(const Formulation formulation)
  {
    std::cout << "formulation: " << name_of(formulation) << std::endl;
    {
      // a homogeneous deformation, as large as may be
      const Tensor<2, 2> F({{1.3, 0.2}, {-0.1, 0.9}});
      const Tensor<2, 2> C    = transpose(F) * F;
      const double       E_11 = (C[0][0] - 1) / 2, E_22 = (C[1][1] - 1) / 2;
      const double       E_33    = -nu / (1 - nu) * (E_11 + E_22);
      const auto         S       = stress(E_11, E_22, C[0][1]);
      const double       thicken = std::sqrt(1 + 2 * E_33) - 1;
      test(formulation,
           "stretch and shear in the plane, with its change of thickness",
           Theory::nonlinear,
           [&](const Point<3> &x) {
             return Tensor<1, 3>({(F[0][0] - 1) * x[0] + F[0][1] * x[1],
                                  F[1][0] * x[0] + (F[1][1] - 1) * x[1],
                                  thicken * x[2]});
           },
           {{S, S}});
    }

    // small strains and curvatures
    const double e = 1e-3;
    test(formulation,
         "stretch along x",
         Theory::linear,
         [&](const Point<3> &x) {
           return e * Tensor<1, 3>({x[0], -nu * x[1], -nu * x[2]});
         },
         {{{{E * e, 0, 0}}, {{E * e, 0, 0}}}});
    test(formulation,
         "shear in the plane",
         Theory::linear,
         [&](const Point<3> &x) {
           return e * Tensor<1, 3>({x[1], x[0], 0});
         },
         {{stress(0, 0, 2 * e), stress(0, 0, 2 * e)}});

    // in bending, the fibers of the middle surface keep their length; the
    // change of thickness due to Poisson's ratio is not linear and cancels in
    // the mean
    const auto bending = [&](const double k_1, const double k_2) {
      return [=](const Point<3> &x) {
        const double z = x[2] - h / 2;
        return Tensor<1, 3>({k_1 * z * x[0],
                             k_2 * z * x[1],
                             -k_1 * x[0] * x[0] / 2 - k_2 * x[1] * x[1] / 2});
      };
    };
    const double k = e / h;
    test(formulation,
         "bending into a cylinder about y",
         Theory::linear,
         bending(k, 0),
         {{stress(-k * h / 2, 0, 0), stress(k * h / 2, 0, 0)}});
    test(formulation,
         "bending into a cylinder about x",
         Theory::linear,
         bending(0, k),
         {{stress(0, -k * h / 2, 0), stress(0, k * h / 2, 0)}});
    test(formulation,
         "pure bending, with its anticlastic curvature",
         Theory::linear,
         bending(k, -nu * k),
         {{{{-E * k * h / 2, 0, 0}}, {{E * k * h / 2, 0, 0}}}});
    test(formulation,
         "twisting",
         Theory::linear,
         [&](const Point<3> &x) {
           const double z = x[2] - h / 2;
           return k * Tensor<1, 3>({z * x[1], z * x[0], -x[0] * x[1]});
         },
         {{stress(0, 0, -k * h), stress(0, 0, k * h)}});
  }
} // namespace


int
main()
{
  test_all(Formulation::paper);
  test_all(Formulation::standard);
}
