// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_formula_surface_h
#define biface_contact_formula_surface_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <biface/contact/implicit_body.h>
#include <biface/input/formula.h>

namespace Biface
{
  /**
   * The zeros of a formula of x, y and z. Its derivatives are differences of
   * sixth order.
   *
   * The closest point is searched downhill, and then in the ball around the
   * given point up to the surface found so far, in which the formula is
   * sampled: it must not change its sign there. Close to the surface, at a
   * distance well below length(), the result is exact. Farther away, parts of
   * the surface that are small against the distance may be missed.
   */
  class FormulaSurface : public ImplicitSurface
  {
  public:
    /** The surface of a formula. Throws InputError if the text is no formula of
     * x, y and z, is not finite near the origin, has no sign change around it,
     * or no derivatives there.
     * @param entry,text those of the formula.
     * @param size_entry the entry of the length, for error messages.
     * @param size a length over which the formula is smooth. */
    FormulaSurface(const std::string &entry,
                   const std::string &text,
                   const std::string &size_entry,
                   const double       size);

    double
    value(const dealii::Point<3> &x) const override;

    Derivatives
    derivatives(const dealii::Point<3> &x) const override;

    double
    length() const override
    {
      return size;
    }

    void
    search_closest(const dealii::Point<3> &x,
                   const Search           &search) const override;

  private:
    /** The first and second derivatives along a direction, by differences.
     * @param step that of the differences. */
    std::array<double, 2>
    differences(const dealii::Point<3>     &x,
                const dealii::Tensor<1, 3> &direction,
                const double                value,
                const double                step) const;

    dealii::Tensor<1, 3>
    gradient(const dealii::Point<3> &x, const double step) const;

    /** A point of the surface between two points on both sides of it; none if
     * the formula jumps there. */
    std::optional<dealii::Point<3>>
    surface_between(dealii::Point<3> a, dealii::Point<3> b) const;

    /** A point of the surface downhill from a point, if one is found. */
    std::optional<dealii::Point<3>>
    surface_along_gradient(dealii::Point<3> x) const;

    const Formula formula;
    const double  size;
    /** The step of the differences. Unit: length. */
    const double step;
    /** The values of the variables, kept to avoid a new vector for each
     * evaluation. */
    mutable std::vector<double> values = std::vector<double>(3);
    /** A known point of the surface. */
    dealii::Point<3> known;
  };
} // namespace Biface

#endif
