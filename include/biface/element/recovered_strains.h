// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_recovered_strains_h
#define biface_element_recovered_strains_h

#include <array>

#include <biface/element/modes.h>

namespace Biface
{
  /**
   * The strains at the vertices of a cell of any shape from which stresses
   * follow: those of CellTangents::strains_at_vertices() with the strains that
   * groups of modes lack, such that their resultants vanish, as those of the
   * Hellinger-Reissner functional; the resultant of the thickness remains.
   *
   * Without them, the gradient of a stress along one direction brings that of a
   * stress across it that is not there: beside the free edge of a narrow flange
   * that is bent in its plane, stresses are too large by @f$1/(1-\nu^2)@f$.
   * Where the stiffness depends on the direction, a stress along the sides of
   * irregular cells is no better than a strain along them.
   *
   * @param stiffness that of the laminate.
   */
  std::array<Resultants::Vector, 4>
  recovered_strains(const CellTangents       &tangents,
                    const Modes::Vector      &E,
                    const Resultants::Matrix &stiffness);
} // namespace Biface

#endif
