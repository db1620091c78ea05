// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stiffness_of_motions_h
#define biface_stepping_stiffness_of_motions_h

#include <deal.II/base/tensor.h>

#include <limits>
#include <map>
#include <string>

#include <biface/stepping/moving_reactions.h>

namespace Biface
{
  class StageRun;


  /** The change of what the ground, a body or a support exerts on the shell,
   * over its motion between two equilibria. */
  struct Stiffness
  {
    /** The ground approaches, slides or turns; bodies and supports slide. */
    enum class Motion
    {
      approach,
      slide,
      turn
    };

    Motion motion = Motion::slide;
    /** A unit vector along the motion, or along the axis of the turn; that of a
     * support has one component. */
    dealii::Tensor<1, 3> direction;
    /** How far it moves. Unit: length, or degrees. */
    double amount = 0;
    /** The change of force and moment per unit of the motion; not a number if
     * they are not certain to change by the motion alone. Moments refer to the
     * point of the ground that touched the shell first, where it is at the
     * start of the stage. */
    dealii::Tensor<1, 3> force, moment;

    /** The component of the stiffness along the motion: that of the force or,
     * for a turn, of the moment. Not a number without a motion. */
    double
    along() const
    {
      return amount == 0
               ? std::numeric_limits<double>::quiet_NaN()
               : (motion == Motion::turn ? moment : force) * direction;
    }
  };


  /** The stiffness in a step of what alone moves. */
  struct StepStiffness
  {
    /** The loads, and what it exerts, at the start of the stage. */
    LoadLevel      level;
    MovingReaction loaded;
    /** From the start of the stage, and from that of the step. */
    Stiffness secant, tangent;
    /** Why the forces of the secant may change without a motion, in words;
     * empty if they do not. */
    std::string doubt;
  };


  /** The stiffness of what alone moves while the loads rest, by name: the
   * ground, a body or a motion of a support, at the end of a step, by the
   * reactions of Progress and those at its end. Bodies that turn have none.
   * Must be called on all ranks. */
  std::map<std::string, StepStiffness>
  stiffness_of_motions(const StageRun &run, const MovingReactions &now);
} // namespace Biface

#endif
