// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_equations_linearized_resultant_h
#define biface_model_equations_linearized_resultant_h

#include <vector>

#include <biface/base/linear_algebra.h>

namespace Biface
{
  /** A component of the resultant of the forces between the shell and the
   * ground, another body or supports, with its derivatives for a fixed active
   * set. */
  struct LinearizedResultant
  {
    double value = 0;
    /** The sum of the absolute values of the contributions that add up to the
     * value. */
    double magnitude = 0;
    /** The derivative of the value with respect to the displacements. */
    LA::Vector gradient;
    /** The derivatives of the value with respect to load parameters: one for
     * each of the given rates of the loads. */
    std::vector<double> per_load;

    /** Add the resultant of another body, for the same rates. */
    LinearizedResultant &
    operator+=(const LinearizedResultant &other)
    {
      value += other.value;
      magnitude += other.magnitude;
      gradient += other.gradient;
      AssertDimension(per_load.size(), other.per_load.size());
      for (unsigned int i = 0; i < per_load.size(); ++i)
        per_load[i] += other.per_load[i];
      return *this;
    }
  };
} // namespace Biface

#endif
