// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_strain_sampling_h
#define biface_element_strain_sampling_h

namespace Biface
{
  /** The points from which the element takes its strains. */
  enum class StrainSampling
  {
    /** Strains from the four vertices, as in
     * @cite GrigolyukKulikovPlotnikova2004. */
    vertices,
    /** Strains from the vertices, with the quadratic terms of the constant
     * modes as means over the element, and with two modes for the twist: see
     * StrainMeans. */
    means
  };

} // namespace Biface

#endif
