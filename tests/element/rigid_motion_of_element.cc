// SPDX-License-Identifier: LGPL-2.1-or-later

// The strains of elements in a finite rigid motion vanish on a plate; on a
// torus they decrease with the square of the cell size.

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
         const StrainSampling              sampling)
  {
    const std::array<double, 2> faces{{-1, 3.8}};
    const Tensor<1, 3>          t({20, -300, 7});
    const Tensor<1, 3>          axis = Tensor<1, 3>({1, 2, -2}) / 3;
    const Tensor<2, 3>          R =
      Physics::Transformations::Rotations::rotation_matrix_3d(Point<3>(axis),
                                                              1.2);
    double square = 0, area = 0;
    for (const TestCell &cell : make_cells(surface, intervals, faces, sampling))
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const SurfacePoint &point = cell.points[v];
              const Tensor<1, 3>  x =
                point.position + faces[face] * point.frame[2];
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
  for (const auto sampling : {StrainSampling::vertices, StrainSampling::means})
    {
      std::cout << "sampling: " << name_of(sampling) << std::endl;
      check_small("plate",
                  strain(Plane(), {{"0:30:4:1.3", "-10:16:3"}}, sampling),
                  1e-11);

      double coarse = 0;
      for (const std::string n : {"8", "16", "32"})
        {
          const double fine =
            strain(torus(), {{"20:80:" + n, "-10:50:" + n}}, sampling);
          if (coarse > 0)
            check_range(
              "torus, twice the cells: " + n, coarse / fine, 3.7, 4.3);
          coarse = fine;
        }
    }
}
