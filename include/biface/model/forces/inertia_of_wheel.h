// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_inertia_of_wheel_h
#define biface_model_forces_inertia_of_wheel_h

#include <array>
#include <vector>

#include <biface/model/forces/force_term.h>

namespace Biface
{
  /**
   * The inertia of a shell of revolution that turns about its axis, in the
   * frame that does not turn, see Rolling: the material flows along the lines
   * of the mesh.
   *
   * The acceleration of a particle in steady rolling is
   * @f$\Omega^2\partial^2\mathbf x/\partial\varphi^2@f$. Around the closed
   * turn, by parts, its virtual work is that of the centrifugal forces,
   * @f[
   *   \int\varrho\,\Omega^2\,\frac{\partial\mathbf x}{\partial\varphi}\cdot
   *   \frac{\partial\,\delta\mathbf x}{\partial\varphi}\,dV
   *   =\Omega^2\sum_{\text{cells}}\frac w4\sum_q\sum_{pr}m^{pr}\,
   *   \mathbf x'^{\,p}_q\cdot\delta\mathbf x'^{\,r}_q,
   * @f]
   * with the mass moments @f$m^{pr}@f$ of Laminate::mass_moments(), at the
   * vertices q like the strains. The derivative is that of
   * CircumferentialSlope, so that a ring that only expands has no error on any
   * mesh. The tangent is symmetric.
   *
   * Over a StepInTime those of Coriolis and of an angular velocity that changes
   * are added, while Inertia has the rest: the virtual work of
   * @f$-2\Omega\,\dot{\mathbf u}'-\dot\Omega\,\mathbf x'@f$, with the mean
   * velocities of the step and the shape in its middle.
   */
  class InertiaOfWheel : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. */
    explicit InertiaOfWheel(const ShellMesh &mesh);

    bool
    acts_on(const unsigned int cell,
            const State       &state,
            const Loads       &loads) const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_over_step(const CellState &start,
                  const CellState &end,
                  CellForces      &forces) const override;

    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

    void
    add_load_derivative_over_step(
      const CellState           &start,
      const CellState           &end,
      const LoadRates           &rates,
      MixedElement::NodalVector &force) const override;

    /** Add the skew matrix of a cell, times velocities of its nodes, by which
     * the forces of Coriolis and of the transport through the mesh oppose
     * them at an angular velocity. */
    void
    add_gyroscopic(const Cell                &cell,
                   const double               angular_velocity,
                   MixedElement::NodalMatrix &G) const;

    /** The potential of the centrifugal forces,
     * @f$-\frac12\Omega^2\int\varrho\,|\mathbf x'|^2dV@f$: minus the kinetic
     * energy of the rotation. Must be called on all ranks. Unit: force times
     * length. */
    double
    potential(const State &state, const double angular_velocity) const;

    /** Add the momenta of the nodes by the flow of the material,
     * @f$-\Omega\int\varrho\,\mathbf x'\cdot\delta\mathbf x\,dV@f$, on the
     * nodes of the cells of this rank. Unit: force times time. */
    void
    add_momentum(const State &state,
                 const double angular_velocity,
                 LA::Vector  &momentum) const;

  private:
    /** The slopes of both faces at a vertex times the mass moments, and the
     * weight of the vertex. */
    std::array<dealii::Tensor<1, 3>, 2>
    unit_momentum(const Cell                      &cell,
                  const MixedElement::NodalVector &V,
                  const unsigned int               q) const;

    /** The centrifugal forces at the angular velocity 1. */
    MixedElement::NodalVector
    unit_force(const Cell &cell, const MixedElement::NodalVector &V) const;

    /** The forces on a shell whose angular velocity changes by -1 in a unit of
     * time. */
    MixedElement::NodalVector
    unit_change(const Cell &cell, const MixedElement::NodalVector &V) const;

    /** Add a multiple of minus the derivative of unit_force(), or of
     * unit_change(), by the displacements. */
    void
    add_stiffness(const Cell                &cell,
                  const double               factor,
                  MixedElement::NodalMatrix &K) const;
    void
    add_transport(const Cell                &cell,
                  const double               factor,
                  MixedElement::NodalMatrix &K) const;

    using MassMoments = std::array<std::array<double, 2>, 2>;

    const ShellMesh &mesh;
    /** The mass moments by ShellMesh::strips. */
    std::vector<MassMoments> mass_moments;
  };
} // namespace Biface

#endif
