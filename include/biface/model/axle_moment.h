// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_axle_moment_h
#define biface_model_axle_moment_h

#include <biface/base/linear_algebra.h>
#include <biface/model/shell_equations.h>
#include <biface/model/state.h>

namespace Biface
{
  /** The moment of the axle on a wheel about the y axis, with its derivatives.
   * Unit: force times length. */
  struct AxleMoment
  {
    double value = 0;
    /** With respect to the displacements, for a fixed active set. */
    LA::Vector gradient;
    /** With respect to the angular velocity. */
    double per_angular_velocity = 0;
  };


  /**
   * What balances the moment of the foundation about the axle,
   * @f$-\mathbf r\cdot\mathbf f@f$ with the rotation
   * @f$\mathbf r=\mathbf e_y\times\mathbf x@f$ of the deformed outer face. The
   * rim exerts it in addition to what dead loads need: only with it the power
   * of the axle is what the ground takes, since the work of a dead pressure on
   * the particles that flow through a constant shape is minus that of its
   * moment on the rotation. A true pressure has none.
   *
   * Must be called on all ranks.
   */
  AxleMoment
  axle_moment(const ShellEquations &equations,
              const State          &state,
              const Loads          &loads);
} // namespace Biface

#endif
