// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_contact_resultants_h
#define biface_model_quantities_contact_resultants_h

#include <vector>

#include <biface/model/equations/linearized_resultant.h>

namespace Biface
{
  class ContactInteraction;
  class ContactPair;
  struct LoadRates;
  struct Loads;
  struct State;


  /** The compressive force on the ground, along its direction. Unit: force.
   *
   * Must be called on all ranks. */
  LinearizedResultant
  ground_force(const ContactPair            &ground,
               const State                  &state,
               const Loads                  &loads,
               const std::vector<LoadRates> &rates = {});


  /**
   * The moment of the axle on a wheel about the y axis. It is what balances the
   * moments of the ground and of other bodies about the axle, @f$-\mathbf
   * r\cdot\mathbf f@f$ with the rotation @f$\mathbf r=\mathbf e_y\times\mathbf
   * x@f$ of the deformed face about the place of the axle, see
   * displacement_of_axle(). The rim exerts it in addition to what dead loads
   * need: only with it the power of the axle is what the ground takes, since
   * the work of a dead pressure on the particles that flow through a constant
   * shape is minus that of its moment on the rotation. A true pressure has
   * none. Unit: force times length.
   *
   * Must be called on all ranks.
   */
  LinearizedResultant
  axle_moment(const ContactInteraction     &contact,
              const State                  &state,
              const Loads                  &loads,
              const std::vector<LoadRates> &rates = {});


  /**
   * The power of a body, by its forces on the shell, in a motion with the given
   * rates of the loads: for a translation of unit velocity the force along it,
   * for a turn of unit angular velocity the moment about the axis. Over a
   * StepInTime, that of its mean forces; its motions then only translate.
   *
   * Must be called on all ranks; the body must be there.
   */
  LinearizedResultant
  power_of_body(const ContactPair            &pair,
                const State                  &state,
                const Loads                  &loads,
                const LoadRates              &motion,
                const std::vector<LoadRates> &rates = {});
} // namespace Biface

#endif
