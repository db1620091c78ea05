// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_reference_surface_h
#define biface_surface_reference_surface_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <optional>
#include <utility>

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
    /** Position of the point. Unit: length. */
    dealii::Point<3> position;

    /**
     * The orthonormal, right-handed frame
     * @f$\mathbf e_1,\mathbf e_2,\mathbf e_3@f$: the directions of the
     * coordinate lines and the outward normal.
     */
    std::array<dealii::Tensor<1, 3>, 3> frame;

    /** Lamé parameters @f$A_1,A_2@f$. Unit: length per unit of
     * @f$\alpha_a@f$. */
    std::array<double, 2> lame;

    /**
     * Principal curvatures @f$k_1,k_2@f$; positive where
     * @f$\mathbf e_3@f$ points away from the center of curvature. Unit:
     * 1/length.
     */
    std::array<double, 2> curvature;

    /**
     * @f$B_a = A_{c,a}/(A_1A_2)@f$, @f$c\neq a@f$: the derivatives of the Lamé
     * parameters, as geodesic curvatures of the coordinate lines. Unit:
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


  /**
   * The reference surface of a shell: a chart from curvature-line coordinates
   * @f$(\alpha_1,\alpha_2)@f$ to space that also provides its frame, Lamé
   * parameters and curvatures.
   *
   * As a manifold, it can be attached to a triangulation. With
   * dealii::MappingManifold the cells then lie on the exact surface and, if
   * their sides are coordinate lines, have its exact metric.
   *
   * A new surface implements evaluate(), pull_back(), clone(), range() and
   * coordinate_unit().
   */
  class ReferenceSurface : public dealii::ChartManifold<2, 3, 2>
  {
  public:
    /** The choice of a surface, see surface_parameters.h. */
    struct Parameters;

    /**
     * @param periodicity the period of each coordinate, 0 for none.
     */
    explicit ReferenceSurface(
      const dealii::Tensor<1, 2> &periodicity = dealii::Tensor<1, 2>())
      : dealii::ChartManifold<2, 3, 2>(periodicity)
    {}

    /** The geometry at the point with the coordinates @p alpha. */
    virtual SurfacePoint
    evaluate(const dealii::Point<2> &alpha) const = 0;

    /** The coordinates of a point on the surface. */
    virtual dealii::Point<2>
    pull_back(const dealii::Point<3> &point) const override = 0;

    dealii::Point<3>
    push_forward(const dealii::Point<2> &alpha) const override
    {
      return evaluate(alpha).position;
    }

    /** The tangents @f$A_a\mathbf e_a@f$. */
    dealii::DerivativeForm<1, 2, 3>
    push_forward_gradient(const dealii::Point<2> &alpha) const override;

    /** The unit vector along the axis around which the second coordinate lines
     * run; zero if there is none. */
    virtual dealii::Tensor<1, 3>
    axis() const
    {
      return {};
    }

    /** The minimum and maximum of the first coordinate. */
    virtual std::pair<double, double>
    range() const = 0;

    /**
     * The factor from the user's unit of the coordinate @p a to the internal
     * unit: @f$\pi/180@f$ for an angle (degrees), 1 for a length.
     */
    virtual double
    coordinate_unit(const unsigned int a) const = 0;

    /** The values of the variables of a formula of the position, see
     * parse_position_formula(): those of @p x and the coordinates @p alpha in
     * the user's units. */
    std::vector<double>
    formula_variables(const dealii::Point<3> &x,
                      const dealii::Point<2> &alpha) const;

    /** `end` in entries: the largest value of the coordinate @p a in the
     * user's unit, infinite if there is none. Only the first has one. */
    double
    end(const unsigned int a) const;

    /** For a surface that is in equilibrium with the tension of its cords:
     * their angle from the circumference at the crown, in degrees. */
    virtual std::optional<double>
    crown_cord_angle() const
    {
      return {};
    }
  };
} // namespace Biface

#endif
