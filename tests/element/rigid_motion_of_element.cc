// SPDX-License-Identifier: LGPL-2.1-or-later

// The strains of elements in a finite rigid motion vanish on a plate and, where
// vectors are interpolated, on every surface; where components are, they
// decrease on a torus with the square of the cell size.

#include <deal.II/physics/transformations.h>

#include "one_cell.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The root mean square of the strains over the cells of a grid. */
  double
  strain(const ReferenceSurface           &surface,
         const std::array<std::string, 2> &intervals,
         const Formulation                 formulation,
         const double                      taper = 0)
  {
    const FaceHeights  faces([taper](const double alpha_1) {
      return std::array<double, 2>{{-1 - taper * alpha_1, 3.8}};
    });
    const Tensor<1, 3> t({20, -300, 7});
    const Tensor<1, 3> axis = Tensor<1, 3>({1, 2, -2}) / 3;
    const Tensor<2, 3> R =
      Physics::Transformations::Rotations::rotation_matrix_3d(Point<3>(axis),
                                                              1.2);
    double square = 0, area = 0;
    for (const TestCell &cell :
         make_cells(surface, intervals, faces, formulation))
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const SurfacePoint &point  = cell.points[v];
              const double       alpha_1 = surface.pull_back(point.position)[0];
              const Tensor<1, 3> x =
                point.position + faces(alpha_1)[face] * point.frame[2];
              add_face_displacement(point.to_frame(R * x + t - x), v, face, V);
            }
        const Modes::Vector E = MixedElement(cell.geometry, V).strain();
        square += cell.geometry.weight * Modes::mean_product(E, E);
        area += cell.geometry.weight;
      }
    return std::sqrt(square / area);
  }
} // namespace


int
main()
{
  for (const auto formulation : all_elements())
    {
      std::cout << "formulation: " << name_of(formulation) << std::endl;
      check_small("plate",
                  strain(Plane(), {{"0:30:4:1.3", "-10:16:3"}}, formulation),
                  1e-11);
      if (formulation != Formulation::paper)
        {
          for (const double taper : {0., 0.5})
            check_small(
              "torus",
              strain(torus(), {{"20:80:4", "-10:50:4"}}, formulation, taper),
              1e-11);
          continue;
        }

      double coarse = 0;
      for (const std::string n : {"8", "16", "32"})
        {
          const double fine =
            strain(torus(), {{"20:80:" + n, "-10:50:" + n}}, formulation);
          if (coarse > 0)
            check_range(
              "torus, twice the cells: " + n, coarse / fine, 3.7, 4.3);
          coarse = fine;
        }
    }
}
