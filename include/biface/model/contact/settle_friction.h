// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_settle_friction_h
#define biface_model_contact_settle_friction_h

namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  /** At the end of a StepInTime, set what the points of a pair remember of
   * friction. */
  void
  settle_friction_over_step(const ContactPair &contact,
                            const Loads       &loads,
                            State             &state);


  /** The work that friction dissipates in the StepInTime of a state at points
   * that slip, on all ranks. Unit: force times length. */
  double
  friction_work_over_step(const ContactPair &contact,
                          const State       &state,
                          const Loads       &loads);
} // namespace Biface

#endif
