// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/element_mass.h>

namespace Biface
{
  using namespace dealii;

  MixedElement::NodalMatrix
  element_mass(const ElementGeometry                      &geometry,
               const std::array<std::array<double, 2>, 2> &mass_moments)
  {
    // for the mean and the half difference of the faces
    std::array<std::array<double, 2>, 2> moments{};
    for (unsigned int p = 0; p < 2; ++p)
      for (unsigned int q = 0; q < 2; ++q)
        {
          const double                m = mass_moments[p][q];
          const std::array<double, 2> left{{1, MixedElement::face_sign[p]}};
          const std::array<double, 2> right{{1, MixedElement::face_sign[q]}};
          for (unsigned int a = 0; a < 2; ++a)
            for (unsigned int b = 0; b < 2; ++b)
              moments[a][b] += m * left[a] * right[b];
        }

    const std::array<double, 3> density = geometry.area_density();
    MixedElement::NodalMatrix   M{};
    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int s = 0; s < 4; ++s)
        {
          // bilinear in each coordinate: 1/3 at the vertex, 1/6 at its neighbor
          const std::array<double, 2> integral{
            {((r ^ s) & 1) != 0 ? 1. / 6 : 1. / 3,
             ((r ^ s) & 2) != 0 ? 1. / 6 : 1. / 3}};
          double area = density[0] * integral[0] * integral[1];
          // a density that is odd in the cell only where both are the same
          for (unsigned int a = 0; a < 2; ++a)
            if (((r ^ s) >> a & 1) == 0)
              area += ((r >> a) & 1 ? 1. / 6 : -1. / 6) * density[1 + a] *
                      integral[1 - a];
          const Tensor<2, 3> turn = geometry.turn(r, s);
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              for (unsigned int a = 0; a < 2; ++a)
                for (unsigned int b = 0; b < 2; ++b)
                  M[6 * r + 2 * i + a][6 * s + 2 * j + b] =
                    area * moments[a][b] * turn[i][j];
        }
    return M;
  }
} // namespace Biface
