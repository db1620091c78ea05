// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_over_step_h
#define biface_model_contact_contact_over_step_h

#include <optional>

#include <biface/contact/tangential_law.h>

namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  /**
   * The traction of a body at a point over a StepInTime. With the clearances
   * c at its ends and @f$\varphi=\frac12\min(c,0)^2@f$, the multiplier is
   * @f$\varepsilon\,(\varphi_1-\varphi_0)/(c_1-c_0)@f$, so that its work is the
   * change of the energy of the spring, and what
   * DampingInTime::of_contact adds. On a curved body, the normal halfway is
   * corrected such that its product with the motion against the body is the
   * change of the clearance. Friction is that of the place at the end of the
   * step, limited by the pressure over the step; a point that comes sticks
   * where it touches.
   *
   * @param state, loads those at the end of the step.
   * @return nothing if the point touches at neither end.
   */
  std::optional<LinearizedTraction>
  traction_over_step(const ContactPair &contact,
                     const State       &state,
                     const Loads       &loads,
                     const unsigned int point);


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


  /** The energy in the springs of a pair on all ranks,
   * @f$\sum A\,\varepsilon\,\varphi@f$. Unit: force times length. */
  double
  contact_energy(const ContactPair &contact,
                 const State       &state,
                 const Loads       &loads);


  /** The work of a body on the springs of a pair over the StepInTime of a
   * state, on all ranks: that of the tractions on the motion of the body. Unit:
   * force times length. */
  double
  work_of_body_over_step(const ContactPair &contact,
                         const State       &state,
                         const Loads       &loads);
} // namespace Biface

#endif
