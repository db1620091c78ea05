// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_element_mass_h
#define biface_element_element_mass_h

#include <array>

#include <biface/element/mixed_element.h>

namespace Biface
{
  /**
   * The consistent mass matrix of an element.
   *
   * With the displacements @f$v_i=\sum_{q,p}N_qN^pv_{i,q}^p@f$,
   * bilinear on the faces and linear between them, the kinetic energy is
   * @f$\frac12\sum_{rs}\sum_{pq}M_{rs}\,m^{pq}\,
   * \sum_i\dot v_{i,r}^p\,\dot v_{i,s}^q@f$ with
   * @f$M_{rs}=\int N_rN_s\,\bar\mu\,d\alpha_1\,d\alpha_2@f$. Along
   * coordinate lines @f$\bar\mu@f$ is constant, as in all other integrals of
   * the element, on other cells linear, see ElementGeometry::area_density();
   * and the volume of a layer is that of the middle surface times its
   * thickness. As in the strains,
   * the components in the frames of the vertices are interpolated, so that the
   * mass of a rigid translation is that of the element only up to the square
   * of the angle between these frames.
   *
   * @param mass_moments @f$m^{pq}@f$, see Laminate::mass_moments(). Unit:
   * mass/area.
   */
  MixedElement::NodalMatrix
  element_mass(const ElementGeometry                      &geometry,
               const std::array<std::array<double, 2>, 2> &mass_moments);
} // namespace Biface

#endif
