// SPDX-License-Identifier: LGPL-2.1-or-later

// Patch tests with plies at an angle, which couple all strains: states of
// constant strain and of constant curvature and twist are exact in every
// element of an irregular grid, and forces balance at the inner nodes.

#include <functional>
#include <map>

#include <biface/laminate/layup.h>

#include "one_cell.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  using Field = std::function<Tensor<1, 3>(const Point<3> &)>;

  Laminate
  plies()
  {
    Layup::Parameters parameters;
    parameters.plies =
      parse_plies("plies", "cord: 0.8 @ 30, cord: 1.2 @ -52, cord: 0.5 @ 75");
    return Layup(parameters, cord_ply()).laminate(0);
  }


  /** The thickness strain with which there is no thickness stress. */
  double
  thickness_strain(const Resultants::Vector &tangential_strains)
  {
    const Resultants::Matrix D = plies().stiffness();
    return -(D[Resultants::thickness] * tangential_strains) /
           D[Resultants::thickness][Resultants::thickness];
  }


  /** @param exact the strains. */
  void
  test(const Formulation         formulation,
       const std::string        &name,
       const bool                linear,
       const Field              &displacement,
       const Resultants::Vector &exact)
  {
    const Laminate      laminate = plies();
    const ModeStiffness stiffness(laminate.stiffness(), formulation);

    std::map<unsigned int, MixedElement::NodalVector> forces;
    std::map<unsigned int, unsigned int>              n_cells;
    double                                            deviation = 0;
    for (const TestCell &cell :
         make_cells(Plane(),
                    {{"0:30:4:1.3", "-10:10:3:0.7, 10:16:1"}},
                    laminate.face_heights(),
                    formulation))
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              Point<3> x = cell.points[v].position;
              x[2]       = laminate.face_heights()[face];
              add_face_displacement(displacement(x), v, face, V);
            }
        const MixedElement  element(cell.geometry,
                                   linear ? MixedElement::NodalVector() : V);
        const Modes::Vector E =
          linear ? element.strain_variation(V) : element.strain();
        deviation = std::hypot(deviation, (E - Modes::constant(exact)).norm());

        const auto force =
          element.internal_force(stiffness.resultants(E), Modes::Vector());
        for (unsigned int v = 0; v < 4; ++v)
          {
            ++n_cells[cell.vertices[v]];
            for (unsigned int i = 0; i < 6; ++i)
              forces[cell.vertices[v]][i] += force[6 * v + i];
          }
      }

    double       inner = 0, edge = 0;
    unsigned int n_inner = 0;
    for (const auto &node : forces)
      if (n_cells[node.first] == 4)
        {
          inner = std::hypot(inner, node.second.norm());
          ++n_inner;
        }
      else
        edge = std::max(edge, node.second.norm());
    std::cout << name << std::endl;
    check_small("  strains", deviation, 1e-11, exact.norm());
    check_small("  forces at inner nodes", inner, 1e-11, edge);
    check_true("  at nine of them", n_inner == 9);
  }
} // namespace


int
main()
{
  using namespace Resultants;
  for (const auto formulation : {Formulation::paper, Formulation::standard})
    {
      std::cout << "formulation: " << name_of(formulation) << std::endl;

      // a large homogeneous deformation
      const Tensor<2, 3> F({{1.1, 0.2, 0}, {-0.1, 0.9, 0}, {0, 0, 0}});
      const Tensor<2, 3> C = transpose(F) * F;
      Resultants::Vector exact;
      for (unsigned int face = 0; face < 2; ++face)
        {
          for (unsigned int a = 0; a < 2; ++a)
            exact[tangential(a, face)] = (C[a][a] - 1) / 2;
          exact[tangential(2, face)] = C[0][1];
        }
      exact[thickness] = thickness_strain(exact);
      test(
        formulation,
        "homogeneous deformation",
        false,
        [&](const Point<3> &x) {
          Tensor<1, 3> y = F * x;
          y[2]           = std::sqrt(1 + 2 * exact[thickness]) * x[2];
          return y - x;
        },
        exact);

      // small curvatures and twist
      const double k_1 = 1e-3, k_2 = -4e-4, k_12 = 7e-4;
      exact = Resultants::Vector();
      for (unsigned int face = 0; face < 2; ++face)
        {
          const double z             = plies().face_heights()[face];
          exact[tangential(0, face)] = k_1 * z;
          exact[tangential(1, face)] = k_2 * z;
          exact[tangential(2, face)] = 2 * k_12 * z;
        }
      exact[thickness] = thickness_strain(exact);
      test(
        formulation,
        "bending and twisting",
        true,
        [&](const Point<3> &x) {
          return Tensor<1, 3>({x[2] * (k_1 * x[0] + k_12 * x[1]),
                               x[2] * (k_2 * x[1] + k_12 * x[0]),
                               exact[thickness] * x[2] - k_1 * x[0] * x[0] / 2 -
                                 k_2 * x[1] * x[1] / 2 - k_12 * x[0] * x[1]});
        },
        exact);
    }
}
