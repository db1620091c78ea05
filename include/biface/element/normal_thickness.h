// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_normal_thickness_h
#define biface_element_normal_thickness_h

#include <array>

#include <biface/element/modes.h>

namespace Biface
{
  /**
   * What walls of several layers subtract from the modes of
   * @f$\varepsilon_{33}=(\mathbf n\cdot\mathbf n-1)/2@f$.
   *
   * The director @f$\mathbf n@f$ leans where the wall is sheared, so that its
   * length is not the distance of the faces. With the shear strains as means
   * over the faces, @f$g_a=\varepsilon_{a3}^-+\varepsilon_{a3}^+@f$,
   * @f[
   *   \hat\varepsilon_{33}=\varepsilon_{33}-(g_1^2+g_2^2)/2
   * @f]
   * is the strain of the distance, up to terms of third order. Without it, a
   * wall that is sheared under a given normal stress becomes thinner, and a
   * pressure p reduces its tangent shear modulus from G to @f$G-p@f$.
   *
   * The squares are evaluated at the Gauss points of the element, which carry
   * the four modes of the thickness strain.
   */
  namespace NormalThickness
  {
    /** The shear strains @f$g_1,g_2@f$ at the Gauss points. */
    using Shear = std::array<std::array<double, 2>, Modes::n_gauss_points>;

    /** A mode of the transverse shear strain in a direction. */
    struct ShearMode
    {
      unsigned int direction, mode, group;
    };

    /** The modes of both directions. */
    constexpr std::array<ShearMode, 8> shear_modes = [] {
      std::array<ShearMode, 8> list{};
      unsigned int             n = 0;
      for (unsigned int m = 0; m < Modes::groups.size(); ++m)
        for (unsigned int i = 0; i < Modes::groups[m].sampled; ++i)
          for (unsigned int a = 0; a < 2; ++a)
            for (unsigned int face = 0; face < 2; ++face)
              if (Modes::groups[m].strains[i] ==
                  Resultants::transverse(a, face))
                list[n++] = {a, Modes::groups[m].first_mode + i, m};
      return list;
    }();

    /** Call a function for each mode of the transverse shear strains, with the
     * direction a, the number of the mode, its group, and its factor in that
     * direction.
     * @param tangents of the cell, along which the strains that vary are
     * components; null if they are the directions. */
    template <typename Function>
    void
    for_shear_modes(const CellTangents *tangents, const Function &function)
    {
      for (const auto &[a, mode, m] : shear_modes)
        if (!tangents || m == 0)
          function(a, mode, Modes::groups[m], 1.);
        else
          for (unsigned int b = 0; b < 2; ++b)
            function(b, mode, Modes::groups[m], tangents->middle[a][b]);
    }

    /** The number of the mode of the thickness strain in a group. */
    constexpr unsigned int
    mode(const unsigned int group)
    {
      return Modes::mode_of[group][Resultants::thickness];
    }

    inline Shear
    shear(const Modes::Vector &strain, const CellTangents *tangents)
    {
      Shear x{};
      for_shear_modes(tangents,
                      [&](const unsigned int  a,
                          const unsigned int  i,
                          const Modes::Group &group,
                          const double        factor) {
                        for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
                          x[g][a] += factor *
                                     Modes::value_at_gauss_point(group, g) *
                                     strain[i] / 2;
                      });
      return x;
    }

    /** Subtract @p factor times the modes of @f$x_1y_1+x_2y_2@f$ from those of
     * the thickness strain. */
    inline void
    subtract_products(const Shear   &x,
                      const Shear   &y,
                      const double   factor,
                      Modes::Vector &strain)
    {
      for (unsigned int m = 0; m < 4; ++m)
        for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
          strain[mode(m)] -=
            factor * Modes::value_at_gauss_point(Modes::groups[m], g) /
            (Modes::n_gauss_points * Modes::groups[m].weight()) *
            (x[g][0] * y[g][0] + x[g][1] * y[g][1]);
    }

    /** The resultant @f$H_{33}@f$ at the Gauss points. */
    inline std::array<double, Modes::n_gauss_points>
    thickness_resultants(const Modes::Vector &H)
    {
      std::array<double, Modes::n_gauss_points> sums{};
      for (unsigned int m = 0; m < 4; ++m)
        for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
          sums[g] +=
            Modes::value_at_gauss_point(Modes::groups[m], g) * H[mode(m)];
      return sums;
    }

    /** Resultants whose work on a variation of the strains is that of @p H on
     * the thickness strain, @f$-H_{33}\,\mathbf x\cdot\delta\mathbf g@f$. */
    inline Modes::Vector
    resultants(const Shear         &x,
               const Modes::Vector &H,
               const CellTangents  *tangents)
    {
      const auto    H_33 = thickness_resultants(H);
      Modes::Vector result;
      for_shear_modes(tangents,
                      [&](const unsigned int  a,
                          const unsigned int  i,
                          const Modes::Group &group,
                          const double        factor) {
                        for (unsigned int g = 0; g < Modes::n_gauss_points; ++g)
                          result[i] -=
                            factor * Modes::value_at_gauss_point(group, g) /
                            (2 * Modes::n_gauss_points * group.weight()) *
                            H_33[g] * x[g][a];
                      });
      return result;
    }
  } // namespace NormalThickness
} // namespace Biface

#endif
