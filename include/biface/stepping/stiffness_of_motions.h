// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stiffness_of_motions_h
#define biface_stepping_stiffness_of_motions_h

#include <limits>
#include <map>
#include <string>

#include <biface/stepping/moving_reactions.h>

namespace Biface
{
  class StageRun;


  /** The change of the force, or moment, of a support or a body along its
   * motion over that of the motion. Not a number if anything else moves or a
   * load changes, or without an earlier equilibrium. Unit: force/length, or
   * force times length per degree. */
  struct StiffnessOfMotion
  {
    /** From the start of the stage, and from that of the step. */
    double secant  = std::numeric_limits<double>::quiet_NaN();
    double tangent = std::numeric_limits<double>::quiet_NaN();
  };


  /** The stiffness of each motion at the end of a step, by the reactions of
   * Progress and those at its end; a turn of the ground has none here. Must be
   * called on all ranks. */
  std::map<std::string, StiffnessOfMotion>
  stiffness_of_motions(const StageRun &run, const MovingReactions &now);
} // namespace Biface

#endif
