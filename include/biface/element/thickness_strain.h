// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_thickness_strain_h
#define biface_element_thickness_strain_h

namespace Biface
{
  /** Where the element takes its thickness strain from. */
  enum class ThicknessStrain
  {
    /** From the vertices if the wall is a single layer, from the distance of
     * the faces along their normal otherwise. */
    by_layers,
    /** From the directors at the four vertices, as in
     * @cite GrigolyukKulikovPlotnikova2004. */
    vertices,
    /** From the director interpolated between them, see MeanDirector. */
    mean_director,
    /** From the part of that which is normal to the faces, see
     * NormalThickness. Where it varies over the element, tangential strains
     * follow it, see ModeStiffness::release_thickness_strain(). */
    normal
  };
} // namespace Biface

#endif
