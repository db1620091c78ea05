// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_contact_condition_parameters_h
#define biface_contact_contact_condition_parameters_h

#include <array>
#include <optional>

namespace Biface
{
  class EntryDeclarations;


  /** The mortar matrix of a bilinear element, by which its multipliers act on
   * its nodes. */
  enum class MortarMatrix
  {
    /** The mass of bilinear multipliers,
     * @f$M_{rs}=\frac w4\int N_rN_s\,d\xi@f$, as in
     * @cite GrigolyukKulikovPlotnikova2004. Pressures oscillate at the edge of
     * the contact zone, and the tangent is not symmetric. */
    consistent,
    /** The row sums of the consistent matrix on the diagonal: smooth pressures,
     * symmetric tangent. It is the consistent matrix of multipliers that are
     * interpolated by dual basis functions @cite Wohlmuth2000. */
    lumped
  };


  /** The matrix @f$M_{rs}@f$ of a bilinear element, with lexicographic
   * numbering of vertices. It maps nodal values of any distributed load to
   * nodal forces.
   * @param density see ElementGeometry::area_density(). */
  std::array<std::array<double, 4>, 4>
  mortar_matrix(const MortarMatrix kind, const std::array<double, 3> &density);


  /** The parameters of ContactCondition, and of the points at which it
   * holds. */
  struct ContactConditionParameters
  {
    MortarMatrix mortar_matrix = MortarMatrix::lumped;
    /** The penalty stiffness @f$\varepsilon@f$; if not set, it follows from
     * the stiffness of the wall. Unit: pressure/length. */
    std::optional<double> penalty_stiffness;

    /** The number k of @f$k\times k@f$ points of a cell that make contact; 0
     * if the nodes do. */
    unsigned int points_per_side = 0;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check() const;
  };
} // namespace Biface

#endif
