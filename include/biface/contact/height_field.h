// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_height_field_h
#define biface_contact_height_field_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

#include <biface/contact/implicit_body.h>

namespace Biface
{
  /**
   * The body below heights over a rectangular grid: the bicubic spline through
   * them, level across the edges of the grid and constant beyond. Its curvature
   * is continuous, at the edges only its gradient.
   *
   * The closest point of the surface is searched in all cells of the grid, in a
   * tree of boxes around them.
   */
  class HeightField : public ImplicitSurface
  {
  public:
    /** The spline through heights. Throws InputError if the points are not
     * those of a grid, see GridData.
     * @param points u, v and height in any order. Unit: length.
     * @param across,along,up unit vectors of these coordinates, orthogonal to
     * each other.
     * @param name that of the file of the points, for error messages. */
    HeightField(const std::vector<dealii::Point<3>> &points,
                const dealii::Tensor<1, 3>          &across,
                const dealii::Tensor<1, 3>          &along,
                const dealii::Tensor<1, 3>          &up,
                const std::string                   &name);

    double
    value(const dealii::Point<3> &x) const override;

    Derivatives
    derivatives(const dealii::Point<3> &x) const override;

    double
    length() const override
    {
      return smallest_cell;
    }

    void
    search_closest(const dealii::Point<3> &x,
                   const Search           &search) const override;

  private:
    /** The height at a point of the grid, and its derivatives by u, by v, and
     * by both. */
    using Knot = std::array<double, 4>;

    /** A range of cells and of the heights above them. */
    struct Box
    {
      std::array<unsigned int, 2> begin, end;
      double                      lowest, highest;
      /** The numbers of the boxes of both halves; 0 for a single cell. */
      std::array<unsigned int, 2> parts;
    };

    /** The cubic polynomials of a cell by which its knots count: those of the
     * value and of the derivative at the lower end, then those at the upper
     * end.
     * @param derivative 0, 1 or 2, by the coordinate. */
    std::array<double, 4>
    basis(const unsigned int direction,
          const unsigned int cell,
          const double       coordinate,
          const unsigned int derivative) const;

    /** The cell in which a coordinate lies. */
    unsigned int
    find_cell(const unsigned int direction, const double coordinate) const;

    /** The height of the spline or one of its derivatives.
     * @param order the orders of the derivatives by u and v. */
    double
    height(const dealii::Point<2>            &x,
           const std::array<unsigned int, 2> &order) const;

    /** A knot of a cell; those beyond the grid are like those on its edge. */
    const Knot &
    knot(const unsigned int i, const unsigned int j) const;

    /** Add the box of a range of cells, and return its number. */
    unsigned int
    add_box(const std::array<unsigned int, 2> &begin,
            const std::array<unsigned int, 2> &end);

    /** The square of the distance of a point from a box. */
    double
    distance_square(const Box &box, const dealii::Point<3> &x) const;

    /** Search in a box. The coordinates of the point are u, v, height. */
    void
    search_box(const unsigned int      box,
               const dealii::Point<3> &x,
               const Search           &search,
               double                 &distance) const;

    dealii::Point<3>
    coordinates(const dealii::Point<3> &x) const
    {
      return {x * axes[0], x * axes[1], x * axes[2]};
    }

    const std::array<dealii::Tensor<1, 3>, 3> axes;
    /** The rows of the grid and one far beyond it on each side. */
    std::array<std::vector<double>, 2> rows;
    std::vector<Knot>                  knots;
    std::vector<Box>                   boxes;
    double                             smallest_cell;
  };
} // namespace Biface

#endif
