// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_surface_point_h
#define biface_surface_surface_point_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Biface
{
  /**
   * The geometry of the reference surface @f$S@f$ at one point, in orthogonal
   * curvature-line coordinates @f$(\alpha_1,\alpha_2)@f$.
   *
   * The derivatives of the frame are
   * @f[
   *   \mathbf e_{a,a}/A_a = -B_c\,\mathbf e_c - k_a\,\mathbf e_3,\qquad
   *   \mathbf e_{c,a}/A_a =  B_c\,\mathbf e_a,\qquad
   *   \mathbf e_{3,a}/A_a =  k_a\,\mathbf e_a,\qquad c\neq a,
   * @f]
   * so that the strains of @cite GrigolyukKulikovPlotnikova2004, eq. (3),
   * depend on the surface only through @f$A_a@f$, @f$B_a@f$ and @f$k_a@f$.
   */
  struct SurfacePoint
  {
    /** The position of the point. Unit: length. */
    dealii::Point<3> position;

    /**
     * The orthonormal, right-handed frame
     * @f$\mathbf e_1,\mathbf e_2,\mathbf e_3@f$: the directions of the
     * coordinate lines and the outward normal.
     */
    std::array<dealii::Tensor<1, 3>, 3> frame;

    /** The Lamé parameters @f$A_1,A_2@f$. Unit: length per unit of
     * @f$\alpha_a@f$. */
    std::array<double, 2> lame;

    /**
     * Principal curvatures @f$k_1,k_2@f$; positive where
     * @f$\mathbf e_3@f$ points away from the center of curvature. Unit:
     * 1/length.
     */
    std::array<double, 2> curvature;

    /**
     * The geodesic curvatures @f$B_a = A_{c,a}/(A_1A_2)@f$, @f$c\neq a@f$, of
     * the coordinate lines, from the derivatives of the Lamé parameters. Unit:
     * 1/length.
     */
    std::array<double, 2> geodesic;

    /** The components @f$(\mathbf e_1,\mathbf e_2,\mathbf e_3)\cdot\mathbf
     * x@f$ of a Cartesian vector. */
    dealii::Tensor<1, 3>
    to_frame(const dealii::Tensor<1, 3> &x) const
    {
      return dealii::Tensor<1, 3>({frame[0] * x, frame[1] * x, frame[2] * x});
    }

    /** The Cartesian vector with the given components in the frame. */
    dealii::Tensor<1, 3>
    from_frame(const dealii::Tensor<1, 3> &components) const
    {
      return components[0] * frame[0] + components[1] * frame[1] +
             components[2] * frame[2];
    }

    /**
     * The matrix @f$\mathbf C_a@f$ of the derivative of a vector field in
     * frame components, @f$(\mathbf v_{,a}/A_a)_i = v_{i,a}/A_a + (\mathbf
     * C_a\mathbf v)_i@f$. It is skew-symmetric.
     *
     * @param a the direction, 0 or 1.
     */
    dealii::Tensor<2, 3>
    connection(const unsigned int a) const
    {
      const unsigned int   c = 1 - a;
      dealii::Tensor<2, 3> C;
      C[a][c] = geodesic[c];
      C[c][a] = -geodesic[c];
      C[a][2] = curvature[a];
      C[2][a] = -curvature[a];
      return C;
    }
  };
} // namespace Biface

#endif
