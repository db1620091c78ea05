// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_friction_continuation_h
#define biface_stepping_friction_continuation_h

#include <deal.II/base/conditional_ostream.h>

#include <biface/stepping/attempt.h>

namespace Biface
{
  struct ControlTrial;


  /** The last attempt at a step of a wheel that rolls with friction, from the
   * last converged state: with easier laws of friction, from one to the next,
   * up to the given one. These are larger critical velocities, for which
   * friction is nearly viscous, or smaller coefficients of bristles.
   * @param failed the attempt with the given law, which is returned if this
   * fails, too, if the wheel does not roll with friction, or if the step can
   * still be cut and a shorter one is easier. */
  Attempt
  attempt_with_easier_friction(Newton                     &newton,
                               const StageRun             &run,
                               const ControlTrial         &trial,
                               const Attempt              &failed,
                               dealii::ConditionalOStream &out);
} // namespace Biface

#endif
