// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_material_h
#define biface_laminate_material_h

#include <deal.II/base/symmetric_tensor.h>

#include <string>

namespace Biface
{
  /**
   * An orthotropic elastic material in its axes 1, 2, 3 (for a ply: along the
   * fibers or cords, across them in the ply, normal to the ply). Moduli in
   * force/area, Poisson's ratios as
   * @f$\nu_{ij} = -\varepsilon_j/\varepsilon_i@f$ under a stress along i.
   */
  struct Material
  {
    double E_1, E_2, E_3;
    double G_12, G_13, G_23;
    double nu_12, nu_13, nu_23;

    /**
     * A transversely isotropic material about axis 1, with
     * @f$E_L, E_T, G_{LT}, G_{TT}, \nu_{LT}, \nu_{TT}@f$. @f$G_{TT}@f$ is
     * independent, since measured constants rarely satisfy
     * @f$G_{TT} = E_T/2(1+\nu_{TT})@f$ exactly.
     */
    static Material
    transversely_isotropic(const double E_L,
                           const double E_T,
                           const double G_LT,
                           const double G_TT,
                           const double nu_LT,
                           const double nu_TT);

    static Material
    isotropic(const double E, const double nu);

    /**
     * The stiffness @f$b_{ijlm}@f$ in the axes of the material. Unit:
     * force/area.
     *
     * Throws InputError, naming @p name, unless the stiffness is positive
     * definite.
     */
    dealii::SymmetricTensor<4, 3>
    stiffness(const std::string &name) const;
  };


  /**
   * The stiffness in the frame of the shell of a ply whose axis 1 is rotated by
   * @p angle (radians) from @f$\mathbf e_1@f$ toward @f$\mathbf e_2@f$.
   */
  dealii::SymmetricTensor<4, 3>
  rotate_about_normal(const dealii::SymmetricTensor<4, 3> &stiffness,
                      const double                         angle);

  /** The stress in the frame of the shell of a ply whose axis 1 is rotated by
   * @p angle (radians) from @f$\mathbf e_1@f$ toward @f$\mathbf e_2@f$. */
  dealii::SymmetricTensor<2, 3>
  rotate_about_normal(const dealii::SymmetricTensor<2, 3> &stress,
                      const double                         angle);

  /** The Cauchy stress in axes that turn with the material, of a second
   * Piola-Kirchhoff @p stress at a Green-Lagrange @p strain:
   * @f$\mathbf U\mathbf S\mathbf U/\det\mathbf U@f$ with the right stretch
   * tensor @f$\mathbf U@f$. Unit: that of the stress. */
  dealii::SymmetricTensor<2, 3>
  cauchy_stress(const dealii::SymmetricTensor<2, 3> &stress,
                const dealii::SymmetricTensor<2, 3> &strain);
} // namespace Biface

#endif
