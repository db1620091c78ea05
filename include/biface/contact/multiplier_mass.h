// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_multiplier_mass_h
#define biface_contact_multiplier_mass_h

#include <array>

namespace Biface
{
  /** How the nodal multipliers of an element act on its nodes. */
  enum class MultiplierMass
  {
    /** Bilinear times bilinear, @f$M_{rs}=\frac w4\int N_rN_s\,d\xi@f$, as in
     * @cite GrigolyukKulikovPlotnikova2004. Pressures oscillate at the edge of
     * the contact zone, and the tangent is not symmetric. */
    consistent,
    /** Its row sums on the diagonal: smooth pressures, symmetric tangent. */
    lumped
  };


  /** The matrix @f$M_{rs}@f$ of a bilinear element of the given weight,
   * vertices numbered lexicographically. It also is the matrix from nodal
   * values of any distributed load to nodal forces. */
  inline std::array<std::array<double, 4>, 4>
  multiplier_mass(const MultiplierMass kind, const double weight)
  {
    // one-dimensional mean of N_r N_s over an edge
    const double same  = (kind == MultiplierMass::consistent ? 1. / 3 : 1. / 2);
    const double other = (kind == MultiplierMass::consistent ? 1. / 6 : 0.);

    std::array<std::array<double, 4>, 4> M;
    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int s = 0; s < 4; ++s)
        M[r][s] =
          weight * ((r ^ s) & 1 ? other : same) * ((r ^ s) & 2 ? other : same);
    return M;
  }
} // namespace Biface

#endif
