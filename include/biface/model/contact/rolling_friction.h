// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_rolling_friction_h
#define biface_model_contact_rolling_friction_h

#include <deal.II/base/tensor.h>

#include <array>

#include <biface/contact/contact_condition.h>
#include <biface/model/mesh/flow_lines.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/state.h>

namespace Biface
{
  /**
   * Friction at the nodes of a shell that rolls, by the velocity with which its
   * particles slip over the ground, see SlipVelocityLaw. All functions need
   * Loads::foundation and Loads::rolling. Nodes without a stencil, see
   * FlowLines, have no velocity and no friction.
   */
  class RollingFriction
  {
  public:
    /** @param mesh kept by reference. */
    RollingFriction(const ShellMesh &mesh, const ContactCondition &condition);

    /** The velocity of the particle at a node relative to the ground. */
    dealii::Tensor<1, 3>
    relative_velocity(const State       &state,
                      const Loads       &loads,
                      const unsigned int node) const;

    /** The velocity with which the particle at a node slips over the ground:
     * its relative velocity without the part along the normal. */
    dealii::Tensor<1, 3>
    slip_velocity(const State       &state,
                  const Loads       &loads,
                  const unsigned int node) const;

    /** Whether the particle at a node slips, see SlipVelocityLaw::slips().
     * There must be friction. */
    bool
    slips(const State       &state,
          const Loads       &loads,
          const unsigned int node) const;

    /** The tangential traction on the shell at a node in contact, with its
     * derivatives. */
    struct Traction
    {
      /** With the pressure extrapolated linearly from the multiplier of the
       * state to that of the clearance. Unit: force/area. */
      dealii::Tensor<1, 3> value;
      /** Minus the derivative with respect to the position of the node. */
      dealii::Tensor<2, 3> stiffness;
      /** Minus those with respect to the positions of the neighbors along the
       * flow, behind and ahead. */
      std::array<dealii::Tensor<2, 3>, 2> stiffness_of_neighbors{};
      /** The derivative with respect to the velocity of the particle. */
      dealii::Tensor<2, 3> per_velocity;
      /** The derivative with respect to the angular velocity. */
      dealii::Tensor<1, 3> per_angular_velocity;
    };

    /** There must be friction. */
    Traction
    traction(const State       &state,
             const Loads       &loads,
             const unsigned int node) const;

    const FlowLines flow_lines;

  private:
    dealii::Point<3>
    position(const State &state, const unsigned int node) const;

    /** @f$\partial\mathbf x/\partial\varphi@f$ of the outer face at a node
     * with a stencil. */
    dealii::Tensor<1, 3>
    slope(const State &state, const unsigned int node) const;

    const ShellMesh       &mesh;
    const ContactCondition condition;
  };
} // namespace Biface

#endif
