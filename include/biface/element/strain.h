// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_strain_h
#define biface_element_strain_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/laminate/resultants.h>

namespace Biface
{
  /** The change of lengths from the reference surface to the faces, at one
   * point: @f$\zeta_a^\pm = 1 + k_a\delta^\pm@f$ and
   * @f$\bar\zeta_a = 1 + k_a(\delta^-+\delta^+)/2@f$. */
  struct ThicknessMetric
  {
    /** The factors @f$\zeta_a^\pm@f$ as `zeta[face][a]`. */
    std::array<std::array<double, 2>, 2> zeta;
    /** The factors @f$\bar\zeta_a@f$ as `zeta_bar[a]`. */
    std::array<double, 2> zeta_bar;
    /** The tangents @f$\mathbf t_a^\pm@f$ as `tangents[face][a]`: the
     * derivative of the position of an undeformed face at constant
     * @f$\alpha_3@f$ by @f$\alpha_a@f$, divided by @f$A_a\zeta_a^\pm@f$, in the
     * frame at the point. It is @f$\mathbf e_a@f$ on the surface itself, close
     * to it where the positions are interpolated, see Interpolation. */
    std::array<std::array<dealii::Tensor<1, 3>, 2>, 2> tangents;

    ThicknessMetric() = default;

    ThicknessMetric(const std::array<double, 2> &curvature,
                    const std::array<double, 2> &face_heights)
    {
      for (unsigned int a = 0; a < 2; ++a)
        {
          for (unsigned int face = 0; face < 2; ++face)
            {
              zeta[face][a]        = 1 + curvature[a] * face_heights[face];
              tangents[face][a][a] = 1;
            }
          zeta_bar[a] =
            1 + curvature[a] * (face_heights[0] + face_heights[1]) / 2;
        }
    }

    /** The ratio of an area of the middle surface to that of a face,
     * @f$\bar\mu/\mu^\pm@f$. */
    double
    area_ratio(const unsigned int face) const
    {
      return zeta_bar[0] * zeta_bar[1] / (zeta[face][0] * zeta[face][1]);
    }
  };


  /**
   * The arguments of the strains at a point: five vectors, with components in
   * the frame @f$\mathbf e_1,\mathbf e_2,\mathbf e_3@f$ at that point.
   *
   * In the notation of @cite GrigolyukKulikovPlotnikova2004, eq. (3), the
   * components of @f$\mathbf g_1@f$ are
   * @f$(\lambda_1,\omega_1,-\theta_1)@f$, those of @f$\mathbf g_2@f$ are
   * @f$(\omega_2,\lambda_2,-\theta_2)@f$. They are linear in the displacements,
   * so that tangents have exact closed forms.
   */
  struct DisplacementGradient
  {
    /**
     * The derivatives @f$\mathbf g_a^\pm=\mathbf v^\pm_{,a}/A_a@f$ of the
     * displacement vector of a face, as `g[face][a]`. Where the thickness
     * varies, a face is not parallel to the reference surface, and the
     * derivative at constant @f$\alpha_3@f$ enters the strains:
     * @f$\mathbf v^\pm_{,a}/A_a - (\delta^\pm_{,a}/A_a)\boldsymbol\beta@f$,
     * since the displacement is linear over the thickness.
     */
    std::array<std::array<dealii::Tensor<1, 3>, 2>, 2> g;

    /** The derivative over the thickness,
     * @f$\boldsymbol\beta = (\mathbf v^+-\mathbf v^-)/h@f$. */
    dealii::Tensor<1, 3> beta;

    DisplacementGradient &
    operator+=(const DisplacementGradient &other)
    {
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          g[face][a] += other.g[face][a];
      beta += other.beta;
      return *this;
    }
  };


  /**
   * The Green-Lagrange strains of @cite GrigolyukKulikovPlotnikova2004,
   * eqs. (2)-(3), in the order of Resultants:
   * @f{align*}{
   *  \varepsilon_{aa}^\pm &= \mathbf t_a\cdot\mathbf g_a/\zeta_a
   *    + \mathbf g_a\cdot\mathbf g_a/2\zeta_a^2, \\
   *  2\varepsilon_{12}^\pm &= \mathbf t_2\cdot\mathbf g_1/\zeta_1
   *    + \mathbf t_1\cdot\mathbf g_2/\zeta_2
   *    + \mathbf g_1\cdot\mathbf g_2/\zeta_1\zeta_2, \\
   *  2\varepsilon_{a3}^\pm &= (\zeta_a\,\mathbf t_a\cdot\boldsymbol\beta
   *    + \mathbf e_3\cdot\mathbf g_a
   *    + \boldsymbol\beta\cdot\mathbf g_a)/\bar\zeta_a, \\
   *  \varepsilon_{33} &= \mathbf e_3\cdot\boldsymbol\beta
   *    + \boldsymbol\beta\cdot\boldsymbol\beta/2 .
   * @f}
   * with @f$\mathbf t_a=\mathbf e_a@f$ in the paper, see ThicknessMetric. They
   * vanish for every finite rigid motion.
   */
  inline Resultants::Vector
  green_lagrange_strain(const DisplacementGradient &u,
                        const ThicknessMetric      &metric)
  {
    using namespace Resultants;

    Vector strain;
    for (unsigned int face = 0; face < 2; ++face)
      {
        const auto &g    = u.g[face];
        const auto &zeta = metric.zeta[face];
        const auto &t    = metric.tangents[face];
        for (unsigned int a = 0; a < 2; ++a)
          {
            strain[tangential(a, face)] =
              (t[a] * g[a]) / zeta[a] + (g[a] * g[a]) / (2 * zeta[a] * zeta[a]);
            strain[transverse(a, face)] =
              (zeta[a] * (t[a] * u.beta) + g[a][2] + u.beta * g[a]) /
              metric.zeta_bar[a];
          }
        strain[tangential(2, face)] = (t[1] * g[0]) / zeta[0] +
                                      (t[0] * g[1]) / zeta[1] +
                                      (g[0] * g[1]) / (zeta[0] * zeta[1]);
      }
    strain[thickness] = u.beta[2] + (u.beta * u.beta) / 2;
    return strain;
  }


  /**
   * The first variation of the strains at @p u in the direction @p du.
   */
  inline Resultants::Vector
  strain_variation(const DisplacementGradient &u,
                   const DisplacementGradient &du,
                   const ThicknessMetric      &metric)
  {
    using namespace Resultants;

    Vector strain;
    for (unsigned int face = 0; face < 2; ++face)
      {
        const auto &g    = u.g[face];
        const auto &dg   = du.g[face];
        const auto &zeta = metric.zeta[face];
        const auto &t    = metric.tangents[face];
        for (unsigned int a = 0; a < 2; ++a)
          {
            strain[tangential(a, face)] =
              (t[a] * dg[a]) / zeta[a] + (g[a] * dg[a]) / (zeta[a] * zeta[a]);
            strain[transverse(a, face)] =
              (zeta[a] * (t[a] * du.beta) + dg[a][2] + u.beta * dg[a] +
               du.beta * g[a]) /
              metric.zeta_bar[a];
          }
        strain[tangential(2, face)] =
          (t[1] * dg[0]) / zeta[0] + (t[0] * dg[1]) / zeta[1] +
          (g[0] * dg[1] + dg[0] * g[1]) / (zeta[0] * zeta[1]);
      }
    strain[thickness] = du.beta[2] + u.beta * du.beta;
    return strain;
  }


  /**
   * The second variation of the strains, weighted by resultants @f$H@f$: the
   * strains are quadratic in the five vectors, and every quadratic term is a
   * scalar product of two of them, so that
   * @f$\sum_s H_s\,\delta^2\varepsilon_s@f$ couples them by these numbers.
   */
  struct GeometricCoupling
  {
    /** The coefficients of @f$\mathbf g_1\mathbf g_1@f$,
     * @f$\mathbf g_2\mathbf g_2@f$ and @f$\mathbf g_1\mathbf g_2@f$, as
     * `gg[face]`. */
    std::array<std::array<double, 3>, 2> gg;
    /** The coefficients of @f$\mathbf g_a\boldsymbol\beta@f$, as
     * `gb[face][a]`. */
    std::array<std::array<double, 2>, 2> gb;
    /** The coefficient of @f$\boldsymbol\beta\boldsymbol\beta@f$. */
    double bb;

    GeometricCoupling(const Resultants::Vector &H,
                      const ThicknessMetric    &metric)
    {
      using namespace Resultants;
      for (unsigned int face = 0; face < 2; ++face)
        {
          const auto &zeta = metric.zeta[face];
          for (unsigned int a = 0; a < 2; ++a)
            {
              gg[face][a] = H[tangential(a, face)] / (zeta[a] * zeta[a]);
              gb[face][a] = H[transverse(a, face)] / metric.zeta_bar[a];
            }
          gg[face][2] = H[tangential(2, face)] / (zeta[0] * zeta[1]);
        }
      bb = H[thickness];
    }

    /** The coupling of the derivatives along faces with the slope
     * @p slope[face][a] relative to the reference surface, instead of those at
     * constant @f$\alpha_3@f$; see DisplacementGradient::g. */
    GeometricCoupling
    along_faces(const std::array<std::array<double, 2>, 2> &slope) const
    {
      GeometricCoupling result = *this;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double coupled =
              gg[face][a] * slope[face][a] + gg[face][2] * slope[face][1 - a];
            result.gb[face][a] -= coupled;
            result.bb += slope[face][a] * (coupled - 2 * gb[face][a]);
          }
      return result;
    }

    /** The coupling applied to @p u: the work-conjugate vectors of the
     * quadratic part of the strains. */
    DisplacementGradient
    apply(const DisplacementGradient &u) const
    {
      DisplacementGradient result;
      result.beta = bb * u.beta;
      for (unsigned int face = 0; face < 2; ++face)
        for (unsigned int a = 0; a < 2; ++a)
          {
            result.g[face][a] = gg[face][a] * u.g[face][a] +
                                gg[face][2] * u.g[face][1 - a] +
                                gb[face][a] * u.beta;
            result.beta += gb[face][a] * u.g[face][a];
          }
      return result;
    }
  };
} // namespace Biface

#endif
