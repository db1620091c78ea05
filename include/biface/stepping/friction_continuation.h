// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_friction_continuation_h
#define biface_stepping_friction_continuation_h

#include <deal.II/base/conditional_ostream.h>

#include <biface/stepping/attempt.h>

namespace Biface
{
  /** The last attempt at a step of a wheel that rolls with friction, from the
   * last converged state: with larger critical velocities, for which friction
   * is nearly viscous, down to the given one.
   * @param failed the attempt with the given one, which is returned if this
   * fails, too, if the wheel does not roll with friction, or if the step can
   * still be cut. */
  Attempt
  attempt_with_larger_critical_velocities(Newton                     &newton,
                                          const StageRun             &run,
                                          const Control::Trial       &trial,
                                          const Attempt              &failed,
                                          dealii::ConditionalOStream &out);
} // namespace Biface

#endif
