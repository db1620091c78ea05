// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_state_rolling_step_h
#define biface_model_state_rolling_step_h

#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/contact/contact_state.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  /** The time in which a wheel rolls on from one state to another, and what it
   * starts from, see BristleLines. */
  struct RollingStep
  {
    /** The displacements at the start, readable at all nodes of this rank. */
    LA::Vector displacement;
    /** The contact at the start, by ContactPair::number. */
    std::vector<ContactState> contacts;
    /** The loads at the start, with the bodies of this step. */
    Loads loads;
    /** Unit: time. */
    double duration = 0;
    /** Whether the angular velocity is given, and not found by a moment: it
     * then changes evenly in the step; otherwise it is the same in all of it.
     */
    bool angular_velocity_is_given = true;
  };
} // namespace Biface

#endif
