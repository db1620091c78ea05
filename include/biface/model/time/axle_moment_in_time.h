// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_time_axle_moment_in_time_h
#define biface_model_time_axle_moment_in_time_h

#include <vector>

#include <biface/model/equations/linearized_resultant.h>

namespace Biface
{
  class ContactInteraction;
  struct LoadRates;
  struct Loads;
  struct State;


  /**
   * The mean moment of the axle on a wheel over its StepInTime: what the forces
   * of inertia of the shell and StepInTime::moment_of_inertia need in addition
   * to what balances ground and bodies, see axle_moment(). Without other forces
   * that have a moment about the axle it is the rate of the angular momentum.
   * Unit: force times length.
   *
   * Must be called on all ranks.
   * @param loads at the end of the step, with Loads::rolling.
   */
  LinearizedResultant
  axle_moment_in_time(const ContactInteraction     &contact,
                      const State                  &state,
                      const Loads                  &loads,
                      const std::vector<LoadRates> &rates = {});
} // namespace Biface

#endif
