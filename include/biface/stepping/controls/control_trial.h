// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_control_trial_h
#define biface_stepping_controls_control_trial_h

#include <functional>
#include <memory>

#include <biface/solver/control_equation.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  /** A step to try, see Control. */
  struct ControlTrial
  {
    /** The loads, as a function of the load parameters: as many as there are
     * equations, one if there are none. */
    std::function<LoadLevel(const LoadParameters &)> level;
    /** The values of the load parameters or, with equations, the initial
     * guess. */
    LoadParameters mu;
    /** The equations that determine the load parameters; null if they are
     * prescribed. */
    std::shared_ptr<const ControlEquations> equations = nullptr;
    /** The size of the step as a fraction of the stage, for predictors, if
     * states change in proportion to it; otherwise 0. */
    double size = 0;
    /** The loads at a part of a step in time, of which 1 is its end; those that
     * equations find are those of the start. */
    std::function<LoadLevel(const double)> within = {};
  };
} // namespace Biface

#endif
