// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_cord_point_h
#define biface_laminate_cord_point_h

#include <deal.II/base/tensor.h>

#include <biface/laminate/resultants.h>

namespace Biface
{
  /**
   * Cords that go slack, at a height within a ply: a point of the integration
   * over the thickness.
   *
   * In the manner of @cite Bert1977, the sign of the strain along the cords
   * decides: where the strain @f$e@f$ along the cords is negative, the stress
   * along them is smaller by @f$\kappa e@f$, with @f$\kappa=E_L-E_{L,c}@f$ and
   * the modulus
   * @f$E_{L,c}@f$ in compression. The stiffness of the ply is then @f$\mathbf
   * b-\kappa\,\mathbf a\mathbf a^T@f$, where @f$\mathbf a@f$ are the components
   * of the dyad of the cords. A uniaxial stress along the cords has exactly the
   * moduli @f$E_L@f$ in tension and @f$E_{L,c}@f$ in compression, and the same
   * Poisson's ratios. The stress is continuous and proportional to the strains,
   * and has the potential @f$\frac12\boldsymbol\varepsilon\cdot\mathbf
   * b\boldsymbol\varepsilon-\frac12\kappa\min(0,e)^2@f$.
   */
  struct CordPoint
  {
    /** @f$e=\mathbf A\cdot\mathbf E+e_0@f$ with the tangential strains of both
     * faces, in the order of Resultants. */
    dealii::Tensor<1, Resultants::n_tangential> direction;
    /** The part of the thickness of the ply that the point stands for. Unit:
     * length. */
    double thickness;
    /** @f$\kappa@f$. Unit: force/area. */
    double loss;
    /** @f$e_0@f$, the strain that causes the initial stress of the ply. */
    double initial_strain;
  };
} // namespace Biface

#endif
