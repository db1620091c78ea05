// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_follower_pressure_h
#define biface_element_follower_pressure_h

#include <array>

#include <biface/element/geometry.h>
#include <biface/element/mixed_element.h>

namespace Biface
{
  /**
   * The nodal forces of a unit pressure on the deformed inner face of an
   * element, and their derivative.
   *
   * The pressure acts on the area and along the normal that the face has now:
   * with the deformed tangents @f$\mathbf t_a = \zeta_a^-\mathbf e_a +
   * \mathbf g_a^-@f$, the force on an area element of the reference surface is
   * @f$\mathbf t_1\times\mathbf t_2\,A_1A_2\,d\alpha_1 d\alpha_2@f$. It is
   * integrated at the vertices, so that each node carries the force of its own
   * surroundings. The derivative is not symmetric.
   */
  class FollowerPressure
  {
  public:
    /** @param V the nodal displacements, see MixedElement::dof(). */
    FollowerPressure(const ElementGeometry           &geometry,
                     const MixedElement::NodalVector &V);

    const MixedElement::NodalVector &
    force() const
    {
      return nodal_force;
    }

    /** Add the derivative of force(), times @p factor, to @p K. */
    void
    add_derivative(const double factor, MixedElement::NodalMatrix &K) const;

  private:
    const ElementGeometry    &geometry;
    MixedElement::NodalVector nodal_force;
    /** Deformed tangents of the inner face at each vertex. */
    std::array<std::array<dealii::Tensor<1, 3>, 2>, 4> tangents;

    /** Area of the reference surface that belongs to a vertex. */
    double
    area(const unsigned int vertex) const;
  };
} // namespace Biface

#endif
