// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_mean_vectors_h
#define biface_element_mean_vectors_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Biface
{
  /**
   * The arguments of what StrainSampling::means adds to the strains sampled at
   * the vertices: coefficients of the bilinear interpolation of the tangents
   * @f$\mathbf d_a^\pm=\mathbf e_a+\mathbf g_a^\pm/\zeta_a^\pm@f$ of the
   * deformed faces and of the director @f$\mathbf n=\mathbf
   * e_3+\boldsymbol\beta@f$. They are Cartesian vectors, since those at the
   * vertices have components in different frames.
   *
   * With bilinear displacements, @f$\mathbf d_a@f$ varies mainly along the
   * other coordinate: @f$\xi_c@f$ below is that with @f$c\neq a@f$.
   */
  struct MeanVectors
  {
    using Vector = dealii::Tensor<1, 3>;

    /** The coefficients @f$[\mathbf d_a^\pm]_c@f$ of @f$\xi_c@f$ as
     * `slope[face][a]`. */
    std::array<std::array<Vector, 2>, 2> slope;
    /** The means @f$[\mathbf d_a^\pm]_0@f$ as `mean[face][a]`. */
    std::array<std::array<Vector, 2>, 2> mean;
    /** The coefficients @f$[\mathbf n]_c@f$ of @f$\xi_c@f$ as `director[a]`. */
    std::array<Vector, 2> director;

    /** The value of @f$\xi_c@f$ at a vertex, ±1. It is the same at the two
     * neighbors along @f$\alpha_a@f$. */
    static constexpr double
    sign(const unsigned int a, const unsigned int vertex)
    {
      return (vertex & (2 >> a)) == 0 ? -1 : 1;
    }

    MeanVectors &
    operator+=(const MeanVectors &other)
    {
      for (unsigned int a = 0; a < 2; ++a)
        {
          for (unsigned int face = 0; face < 2; ++face)
            {
              slope[face][a] += other.slope[face][a];
              mean[face][a] += other.mean[face][a];
            }
          director[a] += other.director[a];
        }
      return *this;
    }
  };
} // namespace Biface

#endif
