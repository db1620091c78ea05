// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_moving_reactions_h
#define biface_stepping_moving_reactions_h

#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

#include <biface/stepping/load_level.h>

namespace Biface
{
  struct ForceOnShell;
  struct Loads;
  struct PlacedBody;
  class ShellEquations;


  /** What moves on the shell, and what it exerts on the shell. */
  struct MovingReaction
  {
    /** The displacement and the force of a body; those of a support have one
     * component. */
    dealii::Tensor<1, 3> displacement, force;
    /** The rotation of a body as a vector, and its moment about the origin;
     * zero for a support. */
    dealii::Tensor<1, 3> rotation, moment;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &displacement &force &rotation &moment;
    }
  };


  /** All of them in an equilibrium: the ground, the bodies and the motions of
   * supports, see SupportMotion, by name, and the loads with the motions of the
   * ground. */
  struct MovingReactions
  {
    LoadLevel                             level;
    std::map<std::string, MovingReaction> of;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &level &of;
    }
  };


  /** A body at its present place that exerts nothing. */
  MovingReaction
  without_force(const PlacedBody &placed);


  /** The reactions in an equilibrium.
   * @param forces those of forces_on_shell(). */
  MovingReactions
  moving_reactions(const ShellEquations            &equations,
                   const LoadLevel                 &level,
                   const Loads                     &loads,
                   const std::vector<ForceOnShell> &forces);
} // namespace Biface

#endif
