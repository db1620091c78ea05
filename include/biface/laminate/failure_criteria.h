// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_failure_criteria_h
#define biface_laminate_failure_criteria_h

#include <deal.II/base/symmetric_tensor.h>

namespace Biface
{
  /** When a ply fails: the greatest stresses it bears one at a time, all
   * positive. Unit: force/area. */
  struct Strengths
  {
    /** Along the fibers, in tension and in compression. */
    double X_t = 0, X_c = 0;
    /** Across them in the ply. */
    double Y_t = 0, Y_c = 0;
    /** Shear between both directions. */
    double S = 0;
  };

  /**
   * The failure index of the criterion of maximum stress: the greatest of the
   * stresses in the plane of the ply, each as a fraction of its strength. At 1
   * the ply fails.
   *
   * @param stress in the axes of the ply.
   */
  double
  maximum_stress_index(const dealii::SymmetricTensor<2, 3> &stress,
                       const Strengths                     &strengths);

  /**
   * The failure index of the criterion of Tsai and Wu @cite TsaiWu1971 for the
   * stresses in the plane of the ply, with the interaction
   * @f$F_{12} = -\frac12\sqrt{F_{11}F_{22}}@f$: the reciprocal of the number by
   * which these stresses must be multiplied for the ply to fail. So it grows
   * in proportion to the stresses, and at 1 the ply fails.
   *
   * @param stress in the axes of the ply.
   */
  double
  tsai_wu_index(const dealii::SymmetricTensor<2, 3> &stress,
                const Strengths                     &strengths);
} // namespace Biface

#endif
