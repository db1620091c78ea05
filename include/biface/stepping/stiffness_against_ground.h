// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stiffness_against_ground_h
#define biface_stepping_stiffness_against_ground_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>

#include <biface/stepping/load_level.h>

namespace Biface
{
  /** The force and moment that the ground exerts on the shell, and the
   * level of loads at which it does. */
  struct GroundReaction
  {
    LoadLevel            level;
    dealii::Tensor<1, 3> force;
    /** The moment about the origin. Unit: force times length. */
    dealii::Tensor<1, 3> moment;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &level &force &moment;
    }
  };


  /**
   * The stiffness of the shell against a motion of the ground: the change
   * of what the ground exerts on it, per length or per degree of the
   * motion.
   */
  struct StiffnessAgainstGround
  {
    enum class Motion
    {
      approach,
      slide,
      turn
    };

    Motion motion = Motion::approach;
    /** A unit vector along the motion, or along the axis of the turn. */
    dealii::Tensor<1, 3> direction;
    /** The distance or angle by which the ground moves. Unit: length, or
     * degrees. */
    double amount = 0;
    /** The change of force and moment per unit of the motion. */
    dealii::Tensor<1, 3> force, moment;

    /** The component of the stiffness along the motion: that of the force or,
     * for a turn, of the moment. */
    double
    along() const
    {
      return (motion == Motion::turn ? moment : force) * direction;
    }
  };


  /** The stiffness of a step of a stage. */
  struct StepStiffness
  {
    /** The reaction of the ground at the start of the stage. */
    GroundReaction loaded;
    /** The stiffness from the start of the stage to the end of the step. */
    StiffnessAgainstGround secant;
    /** The stiffness from the start of the step to its end. */
    StiffnessAgainstGround tangent;
  };


  /**
   * The stiffness between two states of equilibrium.
   *
   * @param outward the direction from the shell to the ground, about which
   * the ground turns and against which it approaches.
   * @param center the point to which the moments refer.
   * @return nothing unless the ground moves in exactly one way: it either
   * approaches or slides or turns.
   */
  std::optional<StiffnessAgainstGround>
  stiffness_against_ground(const GroundReaction       &from,
                           const GroundReaction       &to,
                           const dealii::Tensor<1, 3> &outward,
                           const dealii::Point<3>     &center);
} // namespace Biface

#endif
