// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_centrifugal_forces_h
#define biface_model_forces_centrifugal_forces_h

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
   * The acceleration of a particle is
   * @f$\Omega^2\partial^2\mathbf x/\partial\varphi^2@f$. Around the closed
   * turn, by parts, its virtual work is that of
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
   */
  class CentrifugalForces : public ForceTerm
  {
  public:
    /** The mesh is kept by reference. */
    explicit CentrifugalForces(const ShellMesh &mesh);

    bool
    acts_on(const unsigned int cell,
            const State       &state,
            const Loads       &loads) const override;

    void
    add(const CellState &at, CellForces &forces) const override;

    void
    add_load_derivative(const CellState           &at,
                        const LoadRates           &rates,
                        MixedElement::NodalVector &force) const override;

  private:
    /** The forces at the angular velocity 1. */
    MixedElement::NodalVector
    unit_force(const CellState &at) const;

    using MassMoments = std::array<std::array<double, 2>, 2>;

    const ShellMesh &mesh;
    /** The mass moments by ShellMesh::strips. */
    std::vector<MassMoments> mass_moments;
  };
} // namespace Biface

#endif
