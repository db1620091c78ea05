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
   * along its current normal. With the deformed tangents @f$\mathbf t_a^\pm@f$
   * of the face, which are
   * @f$\zeta_a^\pm\mathbf e_a + \mathbf v_{,a}^\pm/A_a@f$ if the thickness is
   * constant, the force on an area element of the reference surface is
   * @f$\mp p\,\mathbf t_1\times\mathbf t_2\,A_1A_2\,d\alpha_1 d\alpha_2@f$. It
   * is integrated at the vertices, so that each node carries the force on the
   * area around it. The derivative is not symmetric.
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

  private:
    const ElementGeometry      &geometry;
    const Resultants::Face      face;
    const std::array<double, 4> pressure;
    MixedElement::NodalVector   nodal_force;
    /** The deformed tangents @f$\mathbf t_a^\pm@f$ of the face at each
     * vertex. */
    std::array<std::array<dealii::Tensor<1, 3>, 2>, 4> tangents;

    /** The pressure times the area of the reference surface at a vertex,
     * positive if it acts along the normal. */
    double
    weight(const unsigned int vertex) const;
  };
} // namespace Biface

#endif
