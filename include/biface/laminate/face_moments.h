// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_face_moments_h
#define biface_laminate_face_moments_h

#include <deal.II/base/quadrature_lib.h>

#include <array>

namespace Biface
{
  /** The integrals @f$\int_{z_0}^{z_1} N^p\,dz@f$ and
   * @f$\int_{z_0}^{z_1} N^p N^q\,dz@f$ of the linear shape functions of the two
   * faces over a part of the thickness, which runs from 0 to h. */
  struct FaceMoments
  {
    std::array<double, 2>                first{};
    std::array<std::array<double, 2>, 2> second{};

    FaceMoments(const double z_0, const double z_1, const double h)
    {
      const dealii::QGauss<1> quadrature(2);
      for (unsigned int i = 0; i < quadrature.size(); ++i)
        {
          const double z = z_0 + (z_1 - z_0) * quadrature.point(i)[0];
          const std::array<double, 2> N{{1 - z / h, z / h}};
          for (unsigned int p = 0; p < 2; ++p)
            {
              first[p] += quadrature.weight(i) * (z_1 - z_0) * N[p];
              for (unsigned int q = 0; q < 2; ++q)
                second[p][q] +=
                  quadrature.weight(i) * (z_1 - z_0) * N[p] * N[q];
            }
        }
    }
  };
} // namespace Biface

#endif
