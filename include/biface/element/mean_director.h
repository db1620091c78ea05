// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_mean_director_h
#define biface_element_mean_director_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/element/element_geometry.h>
#include <biface/element/modes.h>
#include <biface/element/strain.h>

namespace Biface
{
  /**
   * What ThicknessStrain::mean_director adds to the modes of
   * @f$\varepsilon_{33}=(\mathbf n\cdot\mathbf n-1)/2@f$, with the director
   * @f$\mathbf n=\mathbf e_3+\boldsymbol\beta@f$ as a Cartesian vector.
   *
   * Between the vertices, @f$\mathbf n=[\mathbf n]_0+[\mathbf n]_1\xi_1
   * +[\mathbf n]_2\xi_2+[\mathbf n]_{12}\xi_1\xi_2@f$. A director that
   * alternates from vertex to vertex counts three times in the mean over the
   * vertices, and nine times if it alternates along both coordinates. The terms
   * @f{align*}{
   *   1:\quad& -\tfrac13\varphi_1[\mathbf n]_1\cdot[\mathbf n]_1
   *     -\tfrac13\varphi_2[\mathbf n]_2\cdot[\mathbf n]_2
   *     -\tfrac49\varphi_1\varphi_2[\mathbf n]_{12}\cdot[\mathbf n]_{12}, \\
   *   \xi_1:\quad& -\tfrac23\varphi_1\varphi_2
   *     [\mathbf n]_2\cdot[\mathbf n]_{12}, \\
   *   \xi_2:\quad& -\tfrac23\varphi_1\varphi_2
   *     [\mathbf n]_1\cdot[\mathbf n]_{12},
   * @f}
   * less their values in the undeformed shell, turn these modes with
   * @f$\varphi_a=1@f$ into those of the interpolated director. With
   * @f$\varphi_a=1/(1+L_a^2/12H^2)@f$, where @f$L_a@f$ is the length of the
   * element along @f$\alpha_a@f$ and H the thickness of the wall, bending of
   * thin shells, in which the director turns between the vertices, does not
   * change the thickness.
   */
  struct MeanDirector
  {
    /** The coefficients @f$[\mathbf n]_1,[\mathbf n]_2,[\mathbf n]_{12}@f$. */
    static constexpr unsigned int       n = 3;
    std::array<dealii::Tensor<1, 3>, n> coefficients;

    /** The value of @f$\xi_1,\xi_2,\xi_1\xi_2@f$ (i = 0, 1, 2) at a vertex,
     * ±1. */
    static constexpr double
    sign(const unsigned int i, const unsigned int vertex)
    {
      return ((i != 1 && (vertex & 1) == 0) ? -1. : 1.) *
             ((i != 0 && (vertex & 2) == 0) ? -1. : 1.);
    }

    MeanDirector &
    operator+=(const MeanDirector &other)
    {
      for (unsigned int i = 0; i < n; ++i)
        coefficients[i] += other.coefficients[i];
      return *this;
    }


    /** The coefficients of the undeformed shell. */
    static MeanDirector
    undeformed(const ElementGeometry &geometry)
    {
      MeanDirector x;
      for (unsigned int q = 0; q < 4; ++q)
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            x.coefficients[i][d] +=
              sign(i, q) / 4 * geometry.vertices[q].axes[d][2];
      return x;
    }


    /** The change of the coefficients by displacements with the given gradients
     * at the vertices. */
    static MeanDirector
    change(const ElementGeometry                     &geometry,
           const std::array<DisplacementGradient, 4> &gradients)
    {
      MeanDirector x;
      for (unsigned int q = 0; q < 4; ++q)
        {
          const dealii::Tensor<1, 3> beta =
            geometry.vertices[q].axes * (gradients[q].beta / 4);
          for (unsigned int i = 0; i < n; ++i)
            x.coefficients[i] += sign(i, q) * beta;
        }
      return x;
    }


    /** A symmetric bilinear form of the coefficients: half of it is a sum of
     * the terms that MeanDirector adds. */
    struct Form
    {
      /** The coefficients of the products of the directors 1, 2 and 12 with
       * themselves, and of 2 and of 1 with 12. */
      double of_1 = 0, of_2 = 0, of_12 = 0, of_2_and_12 = 0, of_1_and_12 = 0;

      /** The form of a sum of the modes of the thickness strain times numbers.
       * @param factors by the groups of Modes. */
      Form(const ElementGeometry       &geometry,
           const std::array<double, 4> &factors)
      {
        const double phi_1 = geometry.director_factor[0],
                     phi_2 = geometry.director_factor[1];
        of_1               = -2. / 3 * phi_1 * factors[0];
        of_2               = -2. / 3 * phi_2 * factors[0];
        of_12              = -8. / 9 * phi_1 * phi_2 * factors[0];
        // the group of xi_2 comes first
        of_1_and_12 = -2. / 3 * phi_1 * phi_2 * factors[1];
        of_2_and_12 = -2. / 3 * phi_1 * phi_2 * factors[2];
      }

      /** The form of the virtual work of resultants.
       * @param H without the weights of modes, which are added here. */
      static Form
      of_resultants(const ElementGeometry &geometry, const Modes::Vector &H)
      {
        std::array<double, 4> factors;
        for (unsigned int m = 0; m < 4; ++m)
          factors[m] = Modes::groups[m].weight() * H[mode(m)];
        return Form(geometry, factors);
      }

      /** The form of the thickness strain of one group. */
      static Form
      of_group(const ElementGeometry &geometry, const unsigned int m)
      {
        std::array<double, 4> factors{};
        factors[m] = 1;
        return Form(geometry, factors);
      }

      MeanDirector
      apply(const MeanDirector &x) const
      {
        const auto  &c = x.coefficients;
        MeanDirector y;
        y.coefficients = {
          {of_1 * c[0] + of_1_and_12 * c[2],
           of_2 * c[1] + of_2_and_12 * c[2],
           of_12 * c[2] + of_1_and_12 * c[0] + of_2_and_12 * c[1]}};
        return y;
      }

      /** The coefficient by which the form couples the directors at two
       * vertices. */
      double
      of_vertices(const unsigned int q, const unsigned int r) const
      {
        const double s_1 = sign(0, q), s_2 = sign(1, q), s_12 = sign(2, q);
        const double t_1 = sign(0, r), t_2 = sign(1, r), t_12 = sign(2, r);
        return (of_1 * s_1 * t_1 + of_2 * s_2 * t_2 + of_12 * s_12 * t_12 +
                of_1_and_12 * (s_1 * t_12 + s_12 * t_1) +
                of_2_and_12 * (s_2 * t_12 + s_12 * t_2)) /
               16;
      }
    };


    /** The number of the mode of the thickness strain in a group. */
    static constexpr unsigned int
    mode(const unsigned int group)
    {
      return Modes::mode_of[group][Resultants::thickness];
    }


    /** Add half of the forms of the modes at @p x and @p y, times @p factor, to
     * the strains. */
    static void
    add_products(const ElementGeometry &geometry,
                 const MeanDirector    &x,
                 const MeanDirector    &y,
                 const double           factor,
                 Modes::Vector         &strain)
    {
      for (unsigned int m = 0; m < 3; ++m)
        {
          const MeanDirector z = Form::of_group(geometry, m).apply(x);
          for (unsigned int i = 0; i < n; ++i)
            strain[mode(m)] +=
              factor / 2 * (z.coefficients[i] * y.coefficients[i]);
        }
    }


    /** The vector that is work-conjugate to @f$\boldsymbol\beta@f$ at a vertex,
     * if this object is to the coefficients: the transpose of change(). */
    dealii::Tensor<1, 3>
    at_vertex(const ElementGeometry &geometry, const unsigned int q) const
    {
      dealii::Tensor<1, 3> sum;
      for (unsigned int i = 0; i < n; ++i)
        sum += sign(i, q) / 4 * coefficients[i];
      return sum * geometry.vertices[q].axes;
    }
  };
} // namespace Biface

#endif
