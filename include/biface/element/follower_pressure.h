// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_follower_pressure_h
#define biface_element_follower_pressure_h

#include <array>

#include <biface/element/mixed_element.h>
#include <biface/element/shell_fe_values.h>

namespace Biface
{
  /**
   * The nodal forces of a pressure on a deformed face of an element and their
   * derivative.
   *
   * The pressure pushes the face toward the shell, on its current area and
   * along its current normal. With the position @f$\mathbf x(\xi_1,\xi_2)@f$ of
   * the deformed face, which ElementGeometry::Stations interpolate, the force
   * that does work on a nodal displacement @f$\mathbf v_q@f$ is
   * @f[
   *   \mathbf f_q = \mp\int p\,
   *     \Bigl(\frac{\partial\mathbf x}{\partial\mathbf v_q}\Bigr)^T
   *     \bigl(\mathbf x_{,1}\times\mathbf x_{,2}\bigr)\,d\xi_1 d\xi_2 ,
   *   \qquad p = \sum_q N_q\,p_q .
   * @f]
   * For a constant pressure the integrand is a polynomial, and the integral is
   * exact. The faces of neighboring cells have their sides in common, so that
   * the forces on a closed shell are the pressure times the gradient of the
   * volume that these faces enclose, and their derivative is symmetric. Single
   * cells do not have a symmetric derivative.
   *
   * If vectors are interpolated, the face is bilinear: with the products
   * @f$\mathbf n_q=\mathbf x_{,1}\times\mathbf x_{,2}@f$ at the vertices, the
   * force of a unit pressure is a third of the sum of @f$\mathbf n_q@f$ and of
   * those at both neighbors. If components are, the face between wide cells
   * around an axis is round.
   */
  class FollowerPressure
  {
  public:
    /**
     * @param V the nodal displacements, see MixedElement::dof().
     * @param face the face on which the pressure acts.
     * @param pressure the pressure at the vertices.
     */
    FollowerPressure(const ElementGeometry           &geometry,
                     const MixedElement::NodalVector &V,
                     const Resultants::Face           face = Resultants::inner,
                     const std::array<double, 4> &pressure = {{1, 1, 1, 1}});

    const MixedElement::NodalVector &
    force() const
    {
      return nodal_force;
    }

    /** Add the derivative of force(), times @p factor, to @p K. */
    void
    add_derivative(const double factor, MixedElement::NodalMatrix &K) const;

    /** The flux of the pressure times the vector field @f$\mathbf A\mathbf x@f$
     * through the deformed face, positive where a positive pressure pushes
     * along the field; exact for a constant pressure.
     * @param A in Cartesian coordinates. If components are interpolated, the
     * field is symmetric about the axis of the surface.
     * @param gradient the derivative by the nodal displacements is added,
     * unless null.
     * @param from a point from which @f$\mathbf x@f$ counts. */
    double
    flux(const dealii::Tensor<2, 3> &A,
         MixedElement::NodalVector  *gradient = nullptr,
         const dealii::Tensor<1, 3> &from     = dealii::Tensor<1, 3>()) const;

  private:
    /** The numbers of Gauss points along both coordinates: for polynomials of
     * the degrees 5 and 3. */
    static constexpr std::array<unsigned int, 2> n_points{{3, 2}};

    /** How the position at a point along @f$\alpha_1@f$, on the side of a
     * vertex, depends on the components at the vertex; and the derivative of
     * that by @f$\xi_1@f$. */
    struct Shape
    {
      dealii::Tensor<2, 3> value, slope;
    };

    std::array<Shape, 4>
    shapes(const unsigned int point) const;

    const ElementGeometry &geometry;
    const Resultants::Face face;
    /** At the quadrature points, times the weight; positive if it acts along
     * the normal. */
    std::array<std::array<double, n_points[1]>, n_points[0]> pressure;
    /** The deformed position, see ElementGeometry::Stations. */
    std::array<std::array<dealii::Tensor<1, 3>, n_points[1]>, n_points[0]>
      positions;
    /** The derivatives of the deformed position. */
    std::array<std::array<std::array<dealii::Tensor<1, 3>, 2>, n_points[1]>,
               n_points[0]>
                              tangents;
    MixedElement::NodalVector nodal_force;
  };
} // namespace Biface

#endif
