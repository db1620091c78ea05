// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_failure_criteria_h
#define biface_laminate_failure_criteria_h

#include <deal.II/base/symmetric_tensor.h>

namespace Biface
{
  /** Strengths of a ply: the stresses at which it fails under each alone, all
   * positive. Unit: force/area. */
  struct Strengths
  {
    /** The strengths along the fibers, in tension and in compression. */
    double X_t = 0, X_c = 0;
    /** The strengths across the fibers in the ply, in tension and in
     * compression. */
    double Y_t = 0, Y_c = 0;
    /** The strength in in-plane shear. */
    double S = 0;
  };

  /**
   * The failure index of the maximum stress criterion: the maximum ratio of a
   * stress in the plane of the ply to its strength. The ply fails at 1.
   *
   * @param stress in the axes of the ply.
   */
  double
  maximum_stress_index(const dealii::SymmetricTensor<2, 3> &stress,
                       const Strengths                     &strengths);

  /**
   * The failure index of the Tsai-Wu criterion @cite TsaiWu1971 for the
   * stresses in the plane of the ply, with the interaction
   * @f$F_{12} = -\frac12\sqrt{F_{11}F_{22}}@f$: the reciprocal of the factor by
   * which these stresses must be multiplied for the ply to fail. It is
   * proportional to the stresses, and the ply fails at 1.
   *
   * @param stress in the axes of the ply.
   */
  double
  tsai_wu_index(const dealii::SymmetricTensor<2, 3> &stress,
                const Strengths                     &strengths);
} // namespace Biface

#endif
