// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_nonlocal_stiffness_h
#define biface_model_forces_nonlocal_stiffness_h

#include <biface/base/linear_algebra.h>

namespace Biface
{
  /** A part of a tangent that connects nodes too far from each other, and too
   * many of them, for a sparse matrix. */
  class NonlocalStiffness
  {
  public:
    virtual ~NonlocalStiffness() = default;

    /** The product with increments of the displacements. Supported ones of
     * @p x count as they are, and the product has zeros there. Must be called
     * on all ranks. */
    virtual void
    vmult(LA::Vector &product, const LA::Vector &x) const = 0;
  };
} // namespace Biface

#endif
