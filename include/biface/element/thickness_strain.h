// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_thickness_strain_h
#define biface_element_thickness_strain_h

namespace Biface
{
  /** The source from which the element takes its thickness strain. */
  enum class ThicknessStrain
  {
    /** The strain from the vertices if the wall is a single layer, otherwise
     * from the distance of the faces along their normal. */
    by_layers,
    /** The strain from the directors at the four vertices, as in
     * @cite GrigolyukKulikovPlotnikova2004. */
    vertices,
    /** The strain from the director interpolated between the vertices, see
     * MeanDirector. */
    mean_director,
    /** The strain from the part of the interpolated director that is normal to
     * the faces, see NormalThickness. Where it varies over the element,
     * tangential strains follow it, see
     * ModeStiffness::release_thickness_strain(). */
    normal
  };

  /** The source of a wall with a number of layers, where it depends on it. */
  inline ThicknessStrain
  of_layers(const ThicknessStrain given, const unsigned int n_layers)
  {
    if (given != ThicknessStrain::by_layers)
      return given;
    return n_layers > 1 ? ThicknessStrain::normal : ThicknessStrain::vertices;
  }
} // namespace Biface

#endif
