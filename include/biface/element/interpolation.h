// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_interpolation_h
#define biface_element_interpolation_h

namespace Biface
{
  /** The quantities that are bilinear in the element. */
  enum class Interpolation
  {
    /** The components of the displacements in the frames
     * @f$\mathbf e_1,\mathbf e_2,\mathbf e_3@f$ of the vertices, with the exact
     * geometry of the surface, as in @cite GrigolyukKulikovPlotnikova2004.
     * Where the frames turn from vertex to vertex, rigid motions strain the
     * element by terms of second order in its size. */
    components,
    /** The displacement vectors and the positions of the faces: no rigid motion
     * strains the element, see Quadrilateral. */
    Cartesian
  };
} // namespace Biface

#endif
