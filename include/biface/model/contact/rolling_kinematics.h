// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_rolling_kinematics_h
#define biface_model_contact_rolling_kinematics_h

#include <deal.II/base/tensor.h>

#include <biface/model/mesh/flow_lines.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/state/state.h>

namespace Biface
{
  /**
   * The velocities with which the particles of a rolling shell pass the nodes
   * of its outer face. All functions need Loads::foundation and Loads::rolling.
   * Nodes without a stencil, see FlowLines, have no velocity.
   */
  class RollingKinematics
  {
  public:
    /** @param mesh kept by reference. */
    explicit RollingKinematics(const ShellMesh &mesh);

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

    /** @f$\partial\mathbf x/\partial\varphi@f$ of the outer face at a node
     * with a stencil. */
    dealii::Tensor<1, 3>
    slope(const State &state, const unsigned int node) const;

    const FlowLines flow_lines;

  private:
    dealii::Point<3>
    position(const State &state, const unsigned int node) const;

    const ShellMesh &mesh;
  };
} // namespace Biface

#endif
