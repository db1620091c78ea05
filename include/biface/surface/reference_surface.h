// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_reference_surface_h
#define biface_surface_reference_surface_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <optional>
#include <utility>
#include <vector>

#include <biface/surface/surface_point.h>

namespace Biface
{
  struct RoundedCorner;


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

    /** Whether points have coordinates: without, evaluate() and pull_back() are
     * not possible, see SurfaceWithoutChart. */
    virtual bool
    has_chart() const
    {
      return true;
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
     * parse_position_formula(), at the position @p x with the coordinates
     * @p alpha, which are in the internal units. */
    std::vector<double>
    formula_variables(const dealii::Point<3> &x,
                      const dealii::Point<2> &alpha) const;

    /** The value of `end` in entries: the largest value of the coordinate @p a
     * in the user's unit, infinite if there is none. Only the first coordinate
     * has one. */
    double
    end(const unsigned int a) const;

    /** The rounded corners along the first coordinate; none for most
     * surfaces. */
    virtual std::vector<RoundedCorner>
    get_corners() const;

    /** The angle of the cords from the circumference at the crown, in degrees,
     * of a surface that is in equilibrium with their tension; none for other
     * surfaces. */
    virtual std::optional<double>
    crown_cord_angle() const
    {
      return {};
    }
  };
} // namespace Biface

#endif
